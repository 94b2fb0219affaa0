"""The check for NDK r23 can fail, and does not where it should not."""
import unittest

import check_portable


class CheckPortable(unittest.TestCase):
    def assert_fault(self, text, part):
        faults = list(check_portable.faults_in(text))
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(part, faults[0][2])

    def test_refuses_what_is_newer(self):
        self.assert_fault("#include <concepts>\n", "no such header")
        self.assert_fault("auto i = std::bit_cast<int>(f);", "not in libc++ 11")
        self.assert_fault("std::jthread worker;", "not in libc++ 11")
        self.assert_fault("std::atomic< std::shared_ptr<int> > p;", "Published")
        self.assert_fault("auto p = std::make_shared<float[]>(3);", "shared arrays")
        self.assert_fault("std::from_chars(a, b, d, std::chars_format::general);", "only integers")
        self.assert_fault("using enum State;", "clang 12")

    def test_accepts_what_is_there(self):
        text = "#include <span>\n#include <numbers>\nstd::from_chars(a, b, count); std::span<int> s; std::optional<int> o;"
        self.assertEqual(list(check_portable.faults_in(text)), [])

    def test_reads_no_comments(self):
        self.assertEqual(list(check_portable.faults_in("// no std::jthread here\n/* nor\n std::format */")), [])

    def test_names_the_line(self):
        self.assertEqual([line for line, _, _ in check_portable.faults_in("/*\n*/\n\nstd::format(x);")], [4])


if __name__ == "__main__":
    unittest.main()
