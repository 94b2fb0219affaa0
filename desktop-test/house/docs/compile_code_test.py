"""The compiler sees the blocks of the documents, and says where they are wrong."""
import pathlib
import unittest

import compile_code

HEADERS = pathlib.Path(__file__).resolve().parents[3] / "core/include"
PAGE = """# Page

```c
#include <glide/glide.h>
int version(void) { return (int)glide_abi_version(); }
```

```sh
./glide build
```

```c fragment
glide_session_reset(session);
```
"""


def faults(text):
    return [compile_code.fault_of(block, "page.md", [HEADERS]) for block in compile_code.blocks_of(text)]


class CompileCode(unittest.TestCase):
    def test_accepts_files_and_fragments(self):
        self.assertEqual(faults(PAGE), ["", ""])

    def test_names_file_and_line_of_what_is_wrong(self):
        self.assertIn("page.md:5:", faults(PAGE.replace("glide_abi_version", "glide_api_version"))[0])
        self.assertIn("page.md:13:", faults(PAGE.replace("reset(session)", "reset()"))[1])

    def test_takes_cpp_for_cpp_20(self):
        needs_20 = "```cpp\n#include <span>\nint first(std::span<const int> s) { return s.front(); }\n```\n"
        self.assertEqual(faults(needs_20), [""])
        self.assertIn("page.md:2:", faults(needs_20.replace("```cpp", "```c"))[0])

    def test_wraps_only_what_says_that_it_is_a_fragment(self):
        self.assertIn("page.md:13:", faults(PAGE.replace("```c fragment", "```c"))[1])


if __name__ == "__main__":
    unittest.main()
