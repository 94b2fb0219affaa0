"""The size check sees the functions that are there, and can fail."""
import pathlib
import unittest

import check_sizes
from cpp_functions import Function, functions, java_functions

SAMPLE = """
#include <vector>  // { braces in comments do not count
namespace glide {
namespace {
constexpr int kTable[] = {1, 2, 3};
const char* kText = R"({ nor do these )";
template <class T, class U>
T add(T a, const std::map<int, U>& b) {
  if (a) {
    return {a};
  }
  return [&] { return a; }();
}
}  // namespace
struct Pose : Base {
  std::array<double, 3> t{0.0, 0.0, 0.0};
  bool operator()(int a) const { return a == 1; }
  explicit Pose(int value) : value_{value}, other_(3) {
    value_ = 4;
  }
};
enum class Kind { a, b };
auto Pose::norm() const -> double {
  return 1.0;
}
TEST(Pose, HasANorm) {
  EXPECT_EQ(1, 1);
}
}  // namespace glide
"""


JAVA = """
package io.example;
/** A {@code brace {} in a comment. */
@RunWith(Runner.class)
public final class Session implements AutoCloseable {
  private final Map<String, Integer> map = new HashMap<>();
  @Test
  @DisplayName("says (this) and {that}")
  void works() throws IOException {
    Runnable step = () -> {
      run();
    };
  }
  public @interface Wanted {}
  record Line(long time, double[] pose) {}
  interface Source {
    default int size() { return 0; }
  }
  // NOLINTNEXTLINE(readability-function-size): the numbers of a pose
  Session(int a, int b) {}
}
"""


def function_of_lines(count):
    return "void f() {\n" + "  g();\n" * (count - 2) + "}\n"


class FindFunctions(unittest.TestCase):
    def test_finds_each_function_once_with_length_and_parameters(self):
        self.assertEqual(
            functions(SAMPLE),
            [
                Function("add", 7, 7, 2),
                Function("operator()", 17, 1, 1),
                Function("Pose", 18, 3, 1),
                Function("Pose::norm", 23, 3, 0),
                Function("TEST", 26, 3, 2),
            ],
        )

    def test_reads_glsl(self):
        shader = "layout(std430, binding = 0) buffer B { float x[]; };\nvoid main() {\n  x[0] = 1.0;\n}\n"
        self.assertEqual(functions(shader), [Function("main", 2, 3, 0)])


    def test_reads_java_without_its_annotations(self):
        self.assertEqual(java_functions(JAVA), [Function("works", 9, 5, 0), Function("size", 17, 1, 0), Function("Session", 20, 1, 2)])


class CheckSizes(unittest.TestCase):
    def faults(self, text, name="core/a.cpp"):
        return check_sizes.check_text(pathlib.Path(name), text)[0]

    def test_accepts_what_is_at_the_limits(self):
        self.assertEqual(self.faults(function_of_lines(60)), [])
        self.assertEqual(self.faults("\n" * 300), [])
        self.assertEqual(self.faults("void f(int a, int b, int c, int d, int e) {}\n"), [])

    def test_refuses_a_file_that_is_too_long(self):
        self.assertIn("301 lines", self.faults("\n" * 301)[0])

    def test_refuses_a_function_that_is_too_long(self):
        self.assertIn("f has 61 lines", self.faults(function_of_lines(61))[0])

    def test_refuses_too_many_parameters(self):
        self.assertIn("6 parameters", self.faults("void f(int a, int b, int c, int d, int e, int g) {}\n")[0])

    def test_accepts_what_a_foreign_interface_dictates(self):
        callback = "void f(int a, int b, int c, int d, int e, int g) {}\n"
        self.assertEqual(self.faults("// NOLINTNEXTLINE(readability-function-size): GL's signature\n" + callback), [])

    def test_measures_java_too(self):
        self.assertIn("f has 61 lines", self.faults("class A {\n" + function_of_lines(61) + "}\n", "A.java")[0])

    def test_measures_files_of_the_web(self):
        self.assertIn("301 lines", self.faults("\n" * 301, "a.js")[0])

    def test_measures_python_too(self):
        text = "def f(a):\n" + "    a += 1\n" * 61
        self.assertIn("f has 62 lines", self.faults(text, "core/a.py")[0])


if __name__ == "__main__":
    unittest.main()
