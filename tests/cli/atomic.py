"""Checks that a killed program left each of its files complete or unchanged."""

import os
import re


def can_hide_files(folder):
    """Tells whether the file system supports unnamed files. Without them, a killed program leaves a hidden file."""
    try:
        os.close(os.open(folder, os.O_TMPFILE | os.O_WRONLY))
        return True
    except OSError:
        return False


def prepare(folder, names, older):
    """Removes these files or, with `older`, replaces them with older ones."""
    for name in names:
        (folder / name).unlink(missing_ok=True)
        if older:
            (folder / name).write_text("older")


def check_files(test, folder, complete, older):
    """Checks that each file is complete, or as `prepare` left it. complete: the bytes of each complete file, by name.
    Returns the names of the complete files.

    A program that is killed while it replaces an older file may leave the new one, complete, under a hidden name; the next
    replacement removes it."""
    names = complete.keys()
    for path in list(folder.iterdir()):
        hidden = re.fullmatch(r"\.(.+)\.gabor-[0-9a-f]{8}", path.name)
        if older and hidden and hidden[1] in names:
            test.assertEqual(path.read_bytes(), complete[hidden[1]], f"{path.name} is not complete")
            path.unlink()
    files = {path.name: path.read_bytes() for path in folder.iterdir()}
    test.assertLessEqual(files.keys(), names, "an unexpected file was left")
    for name, content in complete.items():
        test.assertTrue(files.get(name) in [content, b"older" if older else None], f"{name} is not complete")
    return [name for name in files if files[name] == complete[name]]
