"""Is a command of the documents one that could be run? Its program, options, choices, presets, targets and paths are held
against what the programs themselves say and the checkout has; nothing long is run."""
import functools
import json
import re
import shlex
import subprocess

PATHS = ("scripts/", "desktop-test/", "core/", "cmake/", "shaders/", "jni/", "android/", "docs/")
PROGRAMS = ("./glide", "cmake", "glide-replay", "glide-synth", "glide-growth", "glide_bench")
ASSIGNMENT = re.compile(r"[A-Za-z_]\w*=")
# SOURCE, OUT, "1,2,...": what stands for something; ./x-<abi>.so, a*: for several.
PLACEHOLDER = re.compile(r"[A-Z][A-Z_]*|.*(\.\.\.|<|\*).*")


def words_of(line):
    """Commands of a line as lists of words. [-c FILE] is taken, [options] left out; where one may choose, the first."""
    line = re.sub(r"\[(-[^\]]*)\]|\[[^\]]*\]", lambda match: match.group(1) or "", line)
    commands = [[]]
    for word in shlex.split(line):
        if word in ("&&", "|", ";"):
            commands.append([])
        elif word != "...":
            commands[-1].append(word.removesuffix("..."))
    for command in commands:
        while command and (ASSIGNMENT.match(command[0]) or command[0] == "export"):
            command.pop(0)
    return [command for command in commands if command]


def is_checkable(line):
    """Whether a piece of code in the text is a command, or a path, that can be judged."""
    try:
        commands = words_of(line)
    except ValueError:
        return False
    return bool(commands) and (commands[0][0] in PROGRAMS or commands[0][0].startswith(PATHS))


def options_of(words):
    return [word.split("=")[0] for word in words if re.match(r"--?[A-Za-z]", word)]


class Checker:
    """root: the checkout. glide: the entry script to ask for help; it must not build. environment: for it."""

    def __init__(self, root, glide, environment):
        self.root, self.glide, self.environment, self.answers = root, glide, environment, {}
        self.presets = {preset["name"] for preset in
                        json.loads((root / "CMakePresets.json").read_text())["configurePresets"]}

    def faults(self, line):
        try:
            commands = words_of(line)
        except ValueError as error:
            return [f"cannot be read as a command ({error})"]
        return [fault for words in commands for fault in self.command_faults(words)]

    def command_faults(self, words):
        program = words[0]
        if program == "scripts/with_driver.sh":
            return [*self.driver_faults(words[1:2]), *(self.command_faults(words[2:]) if words[2:] else [])]
        if program == "./glide":
            return self.glide_faults(words[1:])
        if program == "cmake":
            return self.cmake_faults(words[1:])
        if program.startswith("build/"):
            return self.built_faults(program)
        if program.startswith(PATHS):
            return self.script_faults(words)
        return []

    def said(self, *command):
        """(exit status, output) of a short program; it is asked once."""
        if command not in self.answers:
            done = subprocess.run(command, cwd=self.glide.parent, env=self.environment, capture_output=True, text=True, check=False)
            self.answers[command] = done.returncode, done.stdout + done.stderr
        return self.answers[command]

    def option_faults(self, code):
        """An option alone must be one of some command of ./glide."""
        commands = re.findall(r"^  ([a-z]+)  ", self.said(str(self.glide), "--help")[1], re.MULTILINE)
        if not re.match(r"--[a-z]", code):
            return []
        help_texts = "".join(self.said(str(self.glide), command, "--help")[1] for command in commands)
        return [f"no command of ./glide knows {option}" for option in options_of(code.split()) if not knows(help_texts, option)]

    def path_faults(self, path):
        """A path, the part of a file's name before its suffix, or a pattern."""
        if PLACEHOLDER.fullmatch(path) or (self.root / path).exists() or list(self.root.glob(path.rstrip("/") + ".*")):
            return []
        return [f"there is no {path}"]

    def driver_faults(self, words):
        text = (self.root / "scripts/drivers.sh").read_text()
        return [f"there is no driver {word}" for word in words
                if not PLACEHOLDER.fullmatch(word) and not re.search(rf"\b{re.escape(word)}\b", text)]

    def preset_faults(self, words):
        named = [words[at + 1] for at, word in enumerate(words[:-1]) if word == "--preset"]
        return [f"CMakePresets.json has no preset {name}" for name in named if name not in self.presets]

    def script_faults(self, words):
        faults = self.path_faults(words[0])
        options = options_of(words[1:])
        if faults or not options or not words[0].endswith(".py"):
            return faults
        help_text = self.said("python3", "-B", str(self.root / words[0]), "--help")[1]
        return [f"{words[0]} --help does not know {option}" for option in options if not knows(help_text, option)]

    def built_faults(self, program):
        _, preset, *folders = program.split("/")
        faults = [] if preset in self.presets else [f"CMakePresets.json has no preset {preset}"]
        return faults + self.path_faults("/".join(folders[:-1]))

    @functools.cached_property
    def cmake_text(self):
        names = subprocess.run(["git", "ls-files", "*CMakeLists.txt"], cwd=self.root, capture_output=True, text=True, check=True)
        return "\n".join((self.root / name).read_text() for name in names.stdout.split())

    def target_faults(self, names):
        return [f"there is no CMake target {name}" for name in names
                if not PLACEHOLDER.fullmatch(name) and not name.endswith("_test") and not knows(self.cmake_text, name)]

    def cmake_faults(self, words):
        targets = words[words.index("--target") + 1:] if "--target" in words else []
        return [*self.preset_faults(words), *self.target_faults([word for word in targets if word[0] != "-"])]

    def glide_faults(self, words):
        if not words or words[0].startswith("-"):
            return [f"./glide does not know {word}" for word in words if word not in ("-h", "--help")]
        command, *rest = words
        status, help_text = self.said(str(self.glide), command, "--help")
        if status != 0:
            return [f"there is no ./glide {command}"]
        if command == "replay":
            return self.replay_faults(rest)
        if command == "test":
            help_text += self.said("ctest", "--help")[1]
            at = rest.index("--driver") + 1 if "--driver" in rest else len(rest)
            extra = self.driver_faults(rest[at:at + 1])
        elif command == "build":
            after_preset = rest[2:] if rest[:1] == ["--preset"] else rest
            extra = [*self.preset_faults(rest), *self.target_faults(after_preset)]
        else:
            extra = choice_faults(help_text, rest)
        unknown = [option for option in options_of(rest) if not knows(help_text, option)]
        return [*extra, *(f"./glide {command} --help does not know {option}" for option in unknown)]

    def replay_faults(self, words):
        """The program's own parser judges; without a source only whether it knows the options."""
        if options_of(words[:1]):
            help_text = self.said(str(self.glide), "replay", "--help")[1]
            return [f"./glide replay --help does not know {option}" for option in options_of(words) if not knows(help_text, option)]
        words = [re.sub(r"^([a-z]+)(\|[a-z]+)+$", r"\1", word) for word in words]
        status, said = self.said(str(self.glide), "replay", *words, "--print-config")
        return [] if status == 0 else [f"./glide replay does not take this: {said.strip().splitlines()[0]}"]


def knows(help_text, option):
    return re.search(rf"(?<![\w-]){re.escape(option)}(?![\w-])", help_text) is not None


def choice_faults(help_text, words):
    """Values that are none of a|b|c, which the help shows behind the option."""
    for option, value in zip(words, words[1:]):
        shown = re.search(rf"(?<![\w-]){re.escape(option)}[ =]([\w-]+(?:\|[\w-]+)+)", help_text)
        if option.startswith("--") and shown and not PLACEHOLDER.fullmatch(value):
            for choice in value.split("|"):
                if choice not in shown.group(1).split("|"):
                    yield f"{option} is one of {shown.group(1)}, not {choice}"
