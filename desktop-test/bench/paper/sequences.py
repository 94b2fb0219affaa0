"""Finds sequences under folders, and tells which of them are the paper's."""
import dataclasses
import os
import re

# Deeper than ROOT/machine_hall/MH_01_easy/MH_01_easy nobody unpacks.
MAX_DEPTH = 4
EUROC_LISTS = ("mav0/cam0/data.csv", "cam0/data.csv")
# Folder names of the paper's sequences: the original archives', and shortened ones.
PAPER = (
    ("tum3", r"(freiburg3|fr3)_(long_)?office(_household)?(?!_validation)"),
    ("tum2_desk", r"(freiburg2|fr2)_desk(?!_with_person|_secret|_validation)"),
    ("tum2_xyz", r"(freiburg2|fr2)_xyz"),
    ("MH01", r"MH_?0?1(?!\d)"),
    ("MH03", r"MH_?0?3(?!\d)"),
    ("MH05", r"MH_?0?5(?!\d)"),
)


@dataclasses.dataclass(frozen=True)
class Sequence:
    """A dataset folder."""
    name: str  # the folder's
    path: str
    kind: str  # tum or euroc: the layout
    paper: str | None  # key into figures, None for other sequences

    @property
    def patch(self):
        """The paper's patch size for such a dataset, px."""
        return 11 if self.kind == "euroc" else 7


def kind_of(folder):
    """tum, euroc, or None for a folder that is no sequence."""
    if os.path.isfile(os.path.join(folder, "rgb.txt")):
        return "tum"
    if any(os.path.isfile(os.path.join(folder, entry)) for entry in EUROC_LISTS):
        return "euroc"
    return None


def paper_key(name):
    """Which of the paper's sequences a folder of that name holds, or a part of it."""
    return next((key for key, pattern in PAPER if re.search(pattern, name, re.IGNORECASE)), None)


def sequence_of(folder):
    """The Sequence in a folder, or None."""
    kind = kind_of(folder)
    if kind is None:
        return None
    name = os.path.basename(folder)
    if name == "mav0":
        name = os.path.basename(os.path.dirname(folder))
    return Sequence(name, folder, kind, paper_key(name))


def walk(folder, depth):
    sequence = sequence_of(folder)
    if sequence is not None:
        return [sequence]
    if depth == 0:
        return []
    children = sorted(entry.path for entry in os.scandir(folder) if entry.is_dir())
    return [found for child in children for found in walk(child, depth - 1)]


def find(roots):
    """The sequences under the roots, the paper's first and in its order; each folder once."""
    found = {}
    for root in roots:
        for sequence in walk(os.path.realpath(root), MAX_DEPTH):
            found.setdefault(sequence.path, sequence)
    keys = [key for key, _ in PAPER]
    return sorted(found.values(), key=lambda s: (keys.index(s.paper) if s.paper else len(keys), s.name))
