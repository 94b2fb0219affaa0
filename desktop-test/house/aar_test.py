#!/usr/bin/env python3
"""Tests scripts/aar: an archive of small libraries passes its check, and each thing that is wrong with one is named.

usage: aar_test.py ROOT
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

ROOT = pathlib.Path(sys.argv.pop(1))
SCRIPTS = ROOT / "scripts/aar"
SOURCE = "int JNI_OnLoad(void) { return 1; } int glide_session_create(void) { return 0; }"
MANIFEST = """<manifest xmlns:android="http://schemas.android.com/apk/res/android">
  <uses-feature android:glEsVersion="0x00030001" android:required="true" />
</manifest>"""


class Aar(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "src/main").mkdir(parents=True)
        (self.folder / "src/main/AndroidManifest.xml").write_text(MANIFEST)
        (self.folder / "consumer-rules.pro").write_text("-keep class io.github.glideslam.** { *; }\n")
        with zipfile.ZipFile(self.folder / "classes.jar", "w") as classes:
            classes.writestr("io/github/glideslam/Session.class", b"")
        self.aar = self.folder / "glide-slam.aar"

    def library(self, source=SOURCE, page=16384):
        path = self.folder / "lib.so"
        subprocess.run(["cc", "-shared", "-fPIC", f"-Wl,-z,max-page-size={page}", "-x", "c", "-", "-o", str(path)],
                       input=source, text=True, check=True)
        return path

    def package(self, *libraries):
        arguments = [argument for library in libraries for argument in ("--library", library)]
        return subprocess.run(
            [sys.executable, SCRIPTS / "package.py", "--classes", self.folder / "classes.jar", *arguments,
             "--headers", ROOT / "core/include", "--android-project", self.folder, "--version", "1.2.3",
             "--min-sdk", "26", "--output", self.aar], capture_output=True, text=True, check=False)

    def check(self):
        return subprocess.run([sys.executable, SCRIPTS / "check.py", self.aar], capture_output=True, text=True, check=False)

    def assert_fault(self, *words):
        checked = self.check()
        self.assertEqual(checked.returncode, 1, checked.stdout)
        for word in words:
            self.assertIn(word, checked.stderr)

    def change(self, name, content):
        """The archive with one entry replaced, or left out where content is None."""
        with zipfile.ZipFile(self.aar) as archive:
            kept = {entry: archive.read(entry) for entry in archive.namelist() if entry != name}
        if content is not None:
            kept[name] = content
        with zipfile.ZipFile(self.aar, "w") as archive:
            for entry, data in kept.items():
                archive.writestr(entry, data)

    def test_an_archive_of_two_abis_passes(self):
        library = self.library()
        self.assertEqual(self.package(f"arm64-v8a={library}", f"x86_64={library}").returncode, 0)
        checked = self.check()
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.assertIn("arm64-v8a", checked.stdout)

    def test_the_same_input_gives_the_same_bytes(self):
        library = self.library()
        self.package(f"x86_64={library}")
        first = self.aar.read_bytes()
        self.package(f"x86_64={library}")
        self.assertEqual(self.aar.read_bytes(), first)

    def test_names_an_abi_that_android_lacks(self):
        packaged = self.package(f"mips={self.library()}")
        self.assertEqual(packaged.returncode, 1)
        self.assertIn("mips", packaged.stderr)

    def test_names_a_library_that_is_missing(self):
        packaged = self.package("x86_64=/nonexistent.so")
        self.assertEqual(packaged.returncode, 1)
        self.assertIn("/nonexistent.so", packaged.stderr)

    def test_finds_symbols_that_are_not_ours(self):
        self.package(f"x86_64={self.library(SOURCE + ' int cv_imread(void) { return 0; }')}")
        self.assert_fault("x86_64", "cv_imread")

    def test_finds_pages_of_4_kib(self):
        self.package(f"x86_64={self.library(page=4096)}")
        self.assert_fault("aligned to 4096")

    def test_finds_what_is_missing(self):
        self.package(f"x86_64={self.library()}")
        self.change("proguard.txt", None)
        self.assert_fault("proguard.txt is missing")

    def test_finds_a_prefab_module_of_another_schema(self):
        self.package(f"x86_64={self.library()}")
        self.change("prefab/prefab.json", b'{"schema_version": 1, "name": "glide-slam", "dependencies": []}')
        self.assert_fault("prefab.json")

    def test_finds_a_manifest_without_package(self):
        self.package(f"x86_64={self.library()}")
        self.change("AndroidManifest.xml", MANIFEST.encode())
        self.assert_fault("package", "minimal SDK")

    def test_finds_a_manifest_without_opengl(self):
        self.package(f"x86_64={self.library()}")
        self.change("AndroidManifest.xml", b"<manifest />")
        self.assert_fault("OpenGL ES 3.1")


if __name__ == "__main__":
    unittest.main(verbosity=0)
