# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Models from Debian's sweethome3d-furniture as its own catalogues tell them: path, size in metres, creator."""

import functools
import re
import zipfile

FOLDER = "/usr/share/sweethome3d/furniture/"

# id -> (file, licence)
ARCHIVES = {
    "cc0": ("BlendSwap-CC-0.sh3f", "CC0 1.0"),
    "ccby": ("BlendSwap-CC-BY.sh3f", "CC BY 3.0"),
    "kator": ("KatorLegaz.sh3f", "CC BY 3.0 US"),
    "scopia": ("Scopia.sh3f", "CC BY 3.0"),
}


class Model:
    """One entry: `size` is width, depth, height in metres; `rotation` nine numbers or None."""

    def __init__(self, archive, keys):
        self.archive = archive
        self.path = keys["model"].lstrip("/")
        self.size = tuple(float(keys[k]) / 100 for k in ("width", "depth", "height"))
        rotation = keys.get("modelRotation")
        self.rotation = tuple(float(v) for v in rotation.split()) if rotation else None
        self.creator = keys.get("creator", "")
        self.name = self.path.split("/")[1]


@functools.lru_cache(maxsize=None)
def _archive(identity):
    """The archive's models by the name of their folder."""
    with zipfile.ZipFile(FOLDER + ARCHIVES[identity][0]) as file:
        text = file.read("PluginFurnitureCatalog.properties").decode("latin1")
    entries = {}
    for key, number, value in re.findall(r"^(\w+)#(\d+)=(.*)$", text, re.MULTILINE):
        entries.setdefault(number, {})[key] = value.strip()
    models = [Model(identity, keys) for keys in entries.values() if "model" in keys]
    return {model.name: model for model in models}


def find(key):
    """The model "name", or "archive/name" where several archives have one of that name."""
    archive, _, name = key.rpartition("/")
    found = [_archive(a)[name] for a in ([archive] if archive else ARCHIVES) if name in _archive(a)]
    if len(found) != 1:
        raise SystemExit(f"catalogue: {len(found)} models {key!r}: give archive/name, archive one of {', '.join(ARCHIVES)}")
    return found[0]


def credits(keys):
    """(model, creator, archive, licence) of each key, sorted."""
    models = sorted((find(key) for key in keys), key=lambda m: m.name)
    return [(m.name, m.creator, *ARCHIVES[m.archive]) for m in models]
