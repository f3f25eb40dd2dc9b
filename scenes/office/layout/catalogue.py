# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Models used from Debian's sweethome3d-furniture: where they are and their true size in metres."""

FOLDER = "/usr/share/sweethome3d/furniture/"

# id -> (file, licence)
ARCHIVES = {
    "cc0": ("BlendSwap-CC-0.sh3f", "CC0 1.0"),
    "ccby": ("BlendSwap-CC-BY.sh3f", "CC BY 3.0"),
    "kator": ("KatorLegaz.sh3f", "CC BY 3.0 US"),
    "scopia": ("Scopia.sh3f", "CC BY 3.0"),
}
_PREFIX = {"cc0": "blendswap-cc-0", "ccby": "blendswap-cc-by", "kator": "katorlegaz", "scopia": "scopia"}

# name of the model's folder -> (archive, width, depth, height in centimetres, creator)
_MODELS = {
    "apple-ibook-2001": ("kator", 28.5, 27.2, 22.9, "Kator Legaz"),
    "apple_pc": ("scopia", 44, 36.2, 38, "Scopia"),
    "apples": ("scopia", 25.7, 25.7, 16, "Scopia"),
    "augalas": ("cc0", 60.9, 34.9, 31.5, "MZiemys"),
    "bandeja": ("scopia", 26.9, 37.8, 6.5, "Scopia"),
    "basketball": ("cc0", 23.8, 23.8, 23.8, "SEspider"),
    "bonsai-tree": ("scopia", 44.5, 38.2, 42.9, "Scopia"),
    "book": ("ccby", 28.1, 18.4, 2.4, "Jay-Artist"),
    "bookcase": ("ccby", 166.4, 33.1, 186.4, "Gerardbelnder"),
    "caffe_final": ("cc0", 10, 10, 4.3, "Reduno"),
    "cardboard-box": ("scopia", 55, 35, 30, "Scopia"),
    "cissors_swap": ("cc0", 13.7, 6.9, 1.5, "Celticluis"),
    "coffee-mug": ("kator", 8.5, 12, 10.8, "Kator Legaz"),
    "coffee-table2": ("scopia", 123.8, 51.2, 47.7, "Scopia"),
    "coffee_cup": ("ccby", 8.5, 8.5, 13, "Dzerbs"),
    "coffee_machine": ("scopia", 58.2, 40.2, 36.4, "Scopia"),
    "coffeeBrewer": ("cc0", 13.4, 38.5, 27.2, "TreyClaine"),
    "couch": ("cc0", 207.4, 87.6, 85.6, "JosephBennett (TowerCG)"),
    "curtain": ("scopia", 130, 5, 225, "Scopia"),
    "desk_lamp1": ("scopia", 13.7, 34.2, 45, "Scopia"),
    "desk_lamp2": ("scopia", 22.5, 41.7, 40, "Scopia"),
    "door": ("scopia", 96, 17.5, 210, "Scopia"),
    "dustbin": ("cc0", 23.3, 23.3, 35, "Ndakasha"),
    "emergencySign": ("cc0", 30, 3.5, 9, "Marcinc53"),
    "fireExtinguisher": ("cc0", 31.1, 18, 62.3, "Bastable"),
    "frame1": ("scopia", 14.5, 14.5, 19.6, "Scopia & eTeks"),
    "frame2": ("scopia", 14.5, 14.5, 19.9, "Scopia & eTeks"),
    "full-bookcase": ("kator", 89.8, 34.7, 221, "Kator Legaz"),
    "glasses": ("scopia", 15, 14.4, 2.8, "Scopia"),
    "headphones": ("cc0", 18.9, 20, 8.2, "Alaskaman"),
    "inkjet_and_scanner_printer": ("scopia", 44.6, 33.2, 18.9, "Scopia"),
    "iphone": ("cc0", 5.8, 11.5, 0.9, "Bheema"),
    "jar": ("scopia", 24.4, 24.4, 40, "Scopia"),
    "kalender": ("cc0", 12, 7.9, 10.8, "Teguh9384"),
    "keys": ("scopia", 11.5, 11.4, 2.9, "Scopia"),
    "laptop": ("ccby", 33.9, 25.3, 26.6, "Mayollo"),
    "littlePlant": ("cc0", 26.6, 26.6, 23.2, "Rameshrj"),
    "maceta": ("scopia", 59, 65, 58, "Scopia"),
    "mini_stereo": ("scopia", 48.9, 21, 21, "Scopia"),
    "newspaper": ("kator", 26.8, 24.1, 2, "Kator Legaz"),
    "office-chair": ("kator", 64.3, 64.3, 91, "Kator Legaz"),
    "office_box": ("scopia", 212, 53.5, 174.9, "Scopia"),
    "office_chair": ("scopia", 63.5, 63.7, 100, "Scopia"),
    "officeTable": ("ccby", 189.2, 83.4, 75.1, "Nmn9"),
    "open-cardboard-box": ("scopia", 81.5, 62.5, 43.7, "Scopia"),
    "osakaChair": ("cc0", 47.5, 52.5, 77, "Daniliescudsg"),
    "penbox": ("scopia", 7.3, 8.3, 17, "Scopia"),
    "pencil1": ("scopia", 0.95, 13.5, 0.67, "Scopia"),
    "phone": ("scopia", 19.7, 21.9, 7.3, "Scopia"),
    "plant": ("cc0", 81.8, 69, 117.1, "Ndakasha"),
    "plug-TypeE-whites": ("scopia", 8.5, 0.7, 8.5, "Scopia"),
    "radiator1": ("cc0", 216.3, 14.3, 83.4, "Knyghtfall13x"),
    "reflex_camera": ("scopia", 12.5, 14.9, 9.8, "Scopia"),
    "RJ-45-whites": ("scopia", 8.5, 0.6, 8.5, "Scopia"),
    "rubix2": ("ccby", 5.6, 5.6, 5.6, "Farcgs"),
    "smoke-detector": ("scopia", 10, 1.8, 10, "Scopia"),
    "stapler": ("kator", 2.9, 11.6, 3.5, "Kator Legaz"),
    "succulentPlant": ("ccby", 13.6901, 12.8942, 11.3663, "Nmn9"),
    "suit": ("ccby", 44, 11.8, 60, "Rosenth"),
    "switch-whites": ("scopia", 8.5, 1.1, 8.5, "Scopia"),
    "tablet": ("scopia", 17, 24, 0.8, "Scopia"),
    "teapot": ("scopia", 21.7, 14.7, 21.3, "Scopia"),
    "textMarker": ("cc0", 3.1, 10.3, 1.7, "Mothome"),
    "tubular_chair": ("scopia", 53.2, 49.9, 81.4, "Scopia"),
    "video-projector": ("scopia", 47, 37.8, 15.1, "Scopia"),
    "wall-hanger": ("scopia", 45, 6.1, 7.9, "Scopia"),
    "water_cooler": ("scopia", 27.4, 31.8, 132.2, "Scopia"),
    "window-blinds": ("kator", 80, 8.2, 94, "Kator Legaz"),
    "wirelessOfficePhone3": ("ccby", 11.2, 15.75, 17.1, "DennisH2010"),
    "wooden_office_alder_table": ("scopia", 161.5, 94.2, 75.4, "Scopia"),
    "yuccaPlant": ("ccby", 107.9, 102.4, 180, "Betomo16"),
}

# Models that the catalogue turns before use, rows of the rotation.
_ROTATIONS = {
    "headphones": (0, 0, 1, -1, 0, 0, 0, -1, 0),
    "iphone": (1, 0, 0, 0, 0, 1, 0, -1, 0),
    "pencil1": (-1, 0, 0, 0, 0, 1, 0, 1, 0),
}


def catalogue():
    found = {}
    for name, (archive, w, d, h, _) in _MODELS.items():
        path = f"{_PREFIX[archive]}/{name}/{name}.obj"
        found[name] = (archive, path, (w / 100, d / 100, h / 100), _ROTATIONS.get(name))
    return found


def credits(names):
    """(model, creator, archive, licence) of each name, sorted."""
    return [(n, _MODELS[n][4], ARCHIVES[_MODELS[n][0]][0], ARCHIVES[_MODELS[n][0]][1]) for n in sorted(names)]
