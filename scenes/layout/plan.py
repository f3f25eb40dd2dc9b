# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""What every make_scene.py does with its plan: write scene.toml, or print the table of credits."""

import sys

from catalogue import ARCHIVES, FOLDER, credits
from writer import SceneWriter

HEAD = """# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
#
"""


def write_scene(folder, head, parts, lift=0.0):
    """Lets each of `parts` add to the scene; writes folder/scene.toml under `head` and the scene's own meshes.

    Everything stands `lift` metres higher than the plan says, whose z = 0 need not be the lowest floor.

    With --credits it prints the models' table instead, with --check it says whether the files are what it would write.
    """
    scene = SceneWriter(lift)
    for key, (file, _) in ARCHIVES.items():
        scene.table("archive", id=key, file=FOLDER + file)
    for add in parts:
        add(scene)
    if "--credits" in sys.argv:
        for row in credits(scene.used):
            print("| " + " | ".join(row) + " |")
    else:
        files = {folder / "scene.toml": HEAD + head + scene.text()}
        files.update({folder / file: mesh.text() for file, mesh in scene.meshes.items()})
        for file, text in files.items():
            if "--check" not in sys.argv:
                file.write_text(text)
            elif file.read_text() != text:
                sys.exit(f"{file}: not what make_scene.py writes: run it")
