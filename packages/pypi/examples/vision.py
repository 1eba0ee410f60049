"""Shows drifting noise in PsychoPy, or saves its frames without a display.

    python vision.py                 shows it for two seconds
    python vision.py --save FOLDER   writes its frames as PNG

Levels are proportional to luminances: linearize the display's gamma first.
"""

import argparse
import pathlib

import gabor_noise
import numpy as np

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--save", type=pathlib.Path, metavar="FOLDER")
folder = parser.parse_args().save

# Two cycles per degree, one octave and 30 degrees wide, moving to the right at four degrees a second.
movie = gabor_noise.movie((512, 512), 120, frequency=2.0, bandwidth=1.0, orientation=0.0, orientation_bandwidth=np.radians(30),
                          drift_per_frame=4 / 60, contrast=0.25, pixels_per_degree=32, seed=7)
frames = [np.clip(frame, -1, 1) for frame in movie]  # cuts off one value in 16000, as the display does

if folder:
    from PIL import Image
    folder.mkdir(parents=True, exist_ok=True)
    for index, frame in enumerate(frames):
        Image.fromarray(np.uint8(np.round(127.5 * (1 + frame)))).save(folder / f"{index:04}.png")
else:
    from psychopy import core, visual
    window = visual.Window((512, 512), units="pix", color=0)
    pictures = [visual.ImageStim(window, frame[::-1], size=(512, 512)) for frame in frames]  # PsychoPy's y points up
    for picture in pictures:
        picture.draw()
        window.flip()
    core.quit()
