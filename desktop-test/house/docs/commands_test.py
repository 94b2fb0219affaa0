"""The test of the documents' commands can fail, in each of its ways."""
import os
import pathlib
import tempfile
import unittest

import commands
import markdown
import rules
import validity

GLIDE = """#!/bin/bash
case "$*" in
  "--help") echo "  synth     draws"; echo "  replay    tracks" ;;
  "replay --help") echo "--patch N  --tracker hybrid|indirect" ;;
  "replay SOURCE --patch 7 --print-config" | "replay SOURCE --tracker hybrid --print-config") ;;
  "synth --help") echo "--frames INT=300  --camera fisheye|pinhole" ;;
  "test --help") echo "--quick --driver D" ;;
  "build --help") echo "--preset P" ;;
  "fails") echo oh; exit 3 ;;
  *) echo "no: $*"; exit 1 ;;
esac
"""
RULES = "[[command]]\nline = './glide synth OUT'\ncheck = 'only a sketch'\n"


class Checkout(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("glide", GLIDE)
        (self.root / "glide").chmod(0o755)
        self.write("CMakePresets.json", '{"configurePresets": [{"name": "release"}]}')
        self.write("CMakeLists.txt", "add_executable(tool tool.cpp)\n")
        self.write("scripts/drivers.sh", "all_drivers=(zink)\n")
        self.write("core/gpu/tuning.cpp", "")
        self.write("rules.toml", RULES)
        self.write("README.md", "# Front\n\n```sh\n./glide synth OUT   # a comment\n```\n")
        self.write("docs/README.md", "# Documentation\n")
        self.checker = validity.Checker(self.root, self.root / "glide", dict(os.environ))
        self.checker.cmake_text = "add_executable(tool tool.cpp)"

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def rules(self):
        return rules.read(self.root / "rules.toml")


class Rules(Checkout):
    def test_covers_a_command_that_has_a_rule(self):
        self.assertEqual(list(commands.rule_faults(self.root, self.rules())), [])

    def test_tells_what_to_add_for_a_command_without_a_rule(self):
        self.write("README.md", "```sh\n./glide synth OUT\n./glide new thing\n```\n")
        fault, = commands.rule_faults(self.root, self.rules())
        for part in ("README.md:3", "line = './glide new thing'", "run = true", "commands.toml"):
            self.assertIn(part, fault)

    def test_names_a_rule_that_no_document_needs(self):
        self.write("README.md", "")
        fault, = commands.rule_faults(self.root, self.rules())
        self.assertIn("./glide synth OUT", fault)

    def test_names_a_block_of_commands_that_is_not_marked(self):
        self.write("README.md", "```\n./glide synth OUT\n```\n")
        fault, = commands.untagged_faults(self.root)
        self.assertIn("README.md:1", fault)

    def test_refuses_rules_that_are_not_clear(self):
        for rule in ("run = true\ncheck = 'both of them'", "", "run = 'other'", "check = ''", "run = true\nwy = 'typo'"):
            self.write("rules.toml", f"[[command]]\nline = 'a'\n{rule}\n")
            with self.assertRaises(rules.RuleError, msg=rule):
                self.rules()

    def test_refuses_two_rules_for_a_command(self):
        self.write("rules.toml", RULES + RULES)
        with self.assertRaises(rules.RuleError):
            self.rules()

    def test_joins_lines_and_leaves_out_output(self):
        block, = markdown.parse("```console\n$ a b \\\n    c  # why\nsaid\n$ d\n```\n").blocks
        self.assertEqual(list(rules.lines_of(block)), [(2, "a b c"), (5, "d")])


class Validity(Checkout):
    def assert_fault(self, line, part):
        faults = self.checker.faults(line)
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(part, faults[0])

    def test_accepts_what_could_be_run(self):
        for line in ("./glide synth OUT --frames 20 [--camera fisheye]", "./glide replay SOURCE [options] --patch 7 ...",
                     "./glide replay SOURCE --tracker hybrid|indirect", "cmake --build --preset release --target tool",
                     "A=1 scripts/with_driver.sh zink ./glide synth OUT", "core/gpu/tuning", "./glide build tool",
                     "./glide test --driver DRIVER -R name", "./glide replay --tracker"):
            self.assertEqual(self.checker.faults(line), [], line)

    def test_names_what_is_not_there(self):
        for line, part in (("./glide synth OUT --speed 2", "--speed"), ("./glide synth OUT --camera mirror", "mirror"),
                           ("./glide replay SOURCE --patch x", "does not take this"), ("./glide dance", "dance"),
                           ("./glide replay --path", "--path"), ("./glide build --preset fast", "fast"),
                           ("./glide build toool", "toool"), ("./glide test --driver mesa", "mesa"),
                           ("scripts/with_driver.sh mesa true", "mesa"), ("scripts/gone.sh", "scripts/gone.sh"),
                           ("cmake --preset fast", "fast"), ("build/fast/core/tool", "fast"), ("core/gpu/gone", "core/gpu/gone"),
                           ("./glide synth 'OUT", "cannot be read")):
            self.assert_fault(line, part)

    def test_knows_options_that_stand_alone(self):
        for code, count in (("--patch 7", 0), ("--frames", 0), ("--path 7", 1), ("-- x", 0), ("a --path", 0)):
            self.assertEqual(len(self.checker.option_faults(code)), count, code)

    def test_takes_text_for_text(self):
        for code in ("session.update()", "--patch 7", "a | b", "it's"):
            self.assertFalse(validity.is_checkable(code), code)


class Running(Checkout):
    def test_tells_that_a_command_fails_and_what_it_said(self):
        done, output = commands.shell("set -eux\n./glide fails", self.root, dict(os.environ))
        self.assertFalse(done)
        self.assertIn("oh", output)

    def test_runs_what_stands_in_a_rule_in_place_of_the_command(self):
        ruled = {"./glide synth OUT": {"line": "./glide synth OUT", "run": "true", "why": "short"}}
        self.assertEqual(list(commands.scripts_of(self.root, ruled)), [("README.md:4", ["true"])])


if __name__ == "__main__":
    unittest.main()
