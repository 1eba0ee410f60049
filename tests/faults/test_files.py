"""Disks, folders and readers fail while the program works. The output file must be unchanged, complete or absent; one
line must say what failed, and the exit status must tell whether the request was invalid."""

import contextlib
import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import PROGRAM, ProgramTest, environment, gabor, start  # noqa: E402

ROUNDS = int(os.environ.get("GABOR_ROUNDS", 3))
LARGE = ("--size=4000x4000", "--orientation-spread=90") # takes a second


class Folders(ProgramTest):
    def test_a_read_only_folder_is_refused(self):
        mount = ["unshare", "--user", "--map-root-user", "--mount", "sh", "-c"]
        read_only = "mount -t tmpfs -o size=1m tmpfs . && cd . && echo older >old.exr && mount -o remount,ro . && "
        if subprocess.run([*mount, read_only + ":"], cwd=self.folder, capture_output=True).returncode != 0:
            self.skipTest("not allowed to mount a small disk")
        for output in ("old.exr", "new.exr"):
            script = read_only + '{ "$0" "$@"; status=$?; ls -A; cat old.exr; exit $status; }'
            result = gabor("render", "-o", output, "--size=64x64", cwd=self.folder, command=[*mount, script, PROGRAM])
            self.assertEqual((result.returncode, result.stdout), (2, "old.exr\nolder\n"), result.stderr)
            self.assertRegex(result.stderr, r"\Agabor: cannot write [^\n]*Read-only file system[^\n]*\n\Z")

    def test_a_folder_that_vanishes_is_a_failure(self):
        for turn in range(ROUNDS):
            (self.folder / "folder").mkdir()
            process = start("render", "-o", "folder/out.exr", *LARGE, cwd=self.folder)
            while process.poll() is None and not any("folder" in name for name in self.open_files(process)):
                time.sleep(0.002)
            shutil.rmtree(self.folder / "folder")
            _, stderr = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 1)
            self.assertRegex(stderr, r"\Agabor: cannot write folder/out.exr: No such file or directory\n\Z")
            self.assertEqual(self.files(), {})

    def open_files(self, process):
        """Yields the names of the files that a running process has open."""
        for link in pathlib.Path(f"/proc/{process.pid}/fd").glob("*"):
            with contextlib.suppress(FileNotFoundError):
                yield os.readlink(link)


class Streams(ProgramTest):
    def test_a_pipe_takes_no_exr(self):
        self.assert_refused(["it is a pipe"], "render", "-o", "/dev/stdout")
        os.mkfifo(self.folder / "pipe")
        result = gabor("render", "-o", "pipe", cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"\Agabor: cannot write pipe: it is a pipe[^\n]*\n\Z")

    def test_printing_to_a_closed_pipe_ends_quietly(self):
        self.succeed("render", "-o", "out.exr", "--size=64x64")
        before = self.files()
        for arguments in (["devices"], ["--help"], ["render", "--help"], ["stats", "out.exr"], ["stats", "out.exr", "--json", "-"],
                          ["render", "-o", "out.exr", "--size=64x64"]):
            with self.subTest(arguments):
                reader, writer = os.pipe()
                os.close(reader)
                result = gabor(*arguments, cwd=self.folder, stdout=writer)
                os.close(writer)
                self.assertEqual((result.returncode, result.stderr), (0, ""))
                self.assertEqual(self.files(), before)

    def test_printed_text_never_ends_up_in_the_file(self):
        """If a standard stream is closed, the first file that the program opens could get its descriptor."""
        self.succeed("render", "-o", "out.exr", "--size=64x64", "--frames=2")
        whole = self.files()
        for closed in ("<&-", ">&-", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"):
            with self.subTest(closed):
                result = gabor("render", "-o", "out.exr", "--size=64x64", "--frames=2",
                               cwd=self.folder, command=["sh", "-c", f'"$0" "$@" {closed}', PROGRAM])
                self.assertEqual(result.returncode, 1 if " >&-" in " " + closed else 0)
                self.assertEqual(self.files(), whole)
                self.succeed("stats", "out.0001.exr", "--json", "whole.json")
                gabor("stats", "out.0001.exr", "--json", "out.json", cwd=self.folder,
                      command=["sh", "-c", f'"$0" "$@" {closed}', PROGRAM])
                whole_json = (self.folder / "whole.json").read_bytes()
                self.assertEqual((self.folder / "out.json").read_bytes(), whole_json)
                (self.folder / "whole.json").unlink()
                (self.folder / "out.json").unlink()


if __name__ == "__main__":
    unittest.main()
