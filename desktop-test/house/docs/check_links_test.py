"""The check of links can fail, in each of its ways."""
import pathlib
import tempfile
import unittest

import check_links
import markdown

INDEX = "# Documentation\n\n[../README.md](../README.md)\n\n| [page.md](page.md) | [deep](sub/deep.md) |\n"
PAGE = "# A page\n\n[All pages](README.md)\n\n## Part (a): `code`, and more\n\n[here](#part-a-code-and-more)\n"


class CheckLinks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("README.md", "# Front\n\n[docs](docs/README.md) and docs/page.md\n")
        self.write("docs/README.md", INDEX)
        self.write("docs/page.md", PAGE)
        self.write("docs/sub/deep.md", "# Deep\n\n[All pages](../README.md), [part](../page.md#part-a-code-and-more)\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def add(self, name, text):
        self.write(name, (self.root / name).read_text() + text)

    def assert_one_fault(self, *parts):
        faults = check_links.faults_of(self.root)
        self.assertEqual(len(faults), 1, faults)
        for part in parts:
            self.assertIn(part, faults[0])

    def test_accepts_links_that_lead_somewhere(self):
        self.assertEqual(check_links.faults_of(self.root), [])

    def test_refuses_a_link_to_nothing(self):
        self.add("docs/page.md", "\n[x](gone.md)\n")
        self.assert_one_fault("docs/page.md:9", "gone.md")

    def test_refuses_a_link_out_of_the_project(self):
        self.add("docs/page.md", "\n[x](../../elsewhere.md)\n")
        self.assert_one_fault("elsewhere.md")

    def test_refuses_an_anchor_that_no_heading_has(self):
        self.add("docs/sub/deep.md", "\n[x](../page.md#gone)\n")
        self.assert_one_fault("docs/page.md", "#gone")

    def test_takes_no_link_from_code(self):
        self.add("docs/page.md", "\n`a[0](x)`\n\n```\n[x](gone.md)\n```\n")
        self.assertEqual(check_links.faults_of(self.root), [])

    def test_refuses_a_name_in_the_text_that_does_not_exist(self):
        self.add("README.md", "See docs/gone.md.\n")
        self.assert_one_fault("README.md:4", "docs/gone.md")

    def test_tells_what_to_add_for_a_page_that_the_index_lacks(self):
        self.write("docs/sub/new.md", "# New\n\n[All pages](../README.md)\n")
        self.assert_one_fault("docs/README.md", "[...](sub/new.md)")

    def test_tells_what_to_add_to_a_page_without_a_way_back(self):
        self.write("docs/sub/deep.md", "# Deep\n")
        self.assert_one_fault("docs/sub/deep.md", "[All pages](../README.md)")


class Markdown(unittest.TestCase):
    def test_numbers_headings_that_are_twins(self):
        self.assertEqual(markdown.parse("# A b\n## A b\n### A b\n").anchors, {"a-b", "a-b-1", "a-b-2"})

    def test_finds_code_that_is_broken_over_lines(self):
        self.assertEqual(markdown.parse("x\n\ny `./glide\nbench` z\n").code, [(3, "./glide bench")])

    def test_keeps_blocks_with_their_lines(self):
        block, = markdown.parse("a\n  ```sh\n  x\n  y\n  ```\nb\n").blocks
        self.assertEqual((block.language, block.first_line, block.lines), ("sh", 3, ["  x", "  y"]))


if __name__ == "__main__":
    unittest.main()
