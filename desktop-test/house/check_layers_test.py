"""The layer check can fail, in each of its ways."""
import pathlib
import tempfile
import unittest

import check_layers


class CheckLayers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("include/glide/types.h", "#include <vector>")
        self.write("geometry/lie.h", '#include "glide/types.h"\n#include <Eigen/Core>')
        self.write("image/image.h", "")
        self.write("photometric/aligner.h", '#include "geometry/lie.h"\n#include "image/image.h"')
        self.write("gpu/gl.h", '#include "photometric/aligner.h"\n#include <GLES3/gl31.h>')

    def write(self, name, text):
        path = self.root / "core" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text + "\n")

    def faults(self):
        return check_layers.check(self.root)[0]

    def assert_one_fault(self, part):
        faults = self.faults()
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(part, faults[0])

    def test_accepts_includes_downwards(self):
        self.assertEqual(self.faults(), [])

    def test_refuses_includes_upwards(self):
        self.write("geometry/up.cpp", '#include "photometric/aligner.h"')
        self.assert_one_fault("photometric/ is above geometry/")

    def test_refuses_siblings(self):
        self.write("image/side.cpp", '#include "geometry/lie.h"')
        self.assert_one_fault("geometry/ is a sibling of image/")

    def test_refuses_includes_that_are_not_relative_to_core(self):
        self.write("geometry/near.cpp", '#include "lie.h"')
        self.assert_one_fault("relative to core/")

    def test_refuses_gl_outside_of_gpu(self):
        self.write("track/draw.cpp", "#include <GLES3/gl31.h>")
        self.assert_one_fault("GL belongs to")

    def test_refuses_opencv_in_a_geometry_header(self):
        self.write("geometry/two_view.h", "#include <opencv2/core.hpp>")
        self.assert_one_fault("OpenCV belongs to")
        self.write("geometry/two_view.h", "")
        self.write("geometry/two_view.cpp", "#include <opencv2/core.hpp>")
        self.assertEqual(self.faults(), [])

    def test_refuses_ceres_outside_of_optimize(self):
        self.write("mapping/ba.cpp", "#include <ceres/ceres.h>")
        self.assert_one_fault("Ceres belongs to")

    def test_refuses_libraries_in_public_headers(self):
        self.write("include/glide/session.h", "#include <Eigen/Core>")
        self.assert_one_fault("standard library only")

    def test_refuses_folders_without_a_layer(self):
        self.write("utils/stuff.h", "")
        self.assert_one_fault("core/utils/")

    def test_lets_the_java_binding_see_the_c_abi_only(self):
        self.write("../jni/guard.h", "#include <jni.h>")
        self.write("../jni/natives.cpp", '#include "guard.h"\n#include "glide/glide.h"\n#include <vector>')
        self.assertEqual(self.faults(), [])
        self.write("../jni/more.cpp", '#include "glide/session.h"')
        self.assert_one_fault("jni/ includes glide/glide.h and itself")
        self.write("../jni/more.cpp", "#include <Eigen/Core>\n#include <ceres/ceres.h>")
        self.assert_one_fault("ceres")


if __name__ == "__main__":
    unittest.main()
