#!/usr/bin/env python3
"""Tests of what reads the compilers' words and judges them; needs no compiler."""
import unittest

import checks
import disassembly
import driver_output
import gpus
import report

# A loop of one row of three pixels: four fetches. Shortened from what Mesa prints.
BIFROST = """@gpu Mali-G52 (Panfrost)
@variant align_residual.comp PATCH_SIZE=3
shader: MESA_SHADER_COMPUTE
clause_0:
ds(0) nbb ncph next_load
{
    *LSHIFT_OR.i32 r0:t0, r61, #0, 0x00000002
    +NOP t1
}
clause_4:
ds(0) nbb load ncph next_tex dwb(0)
{
    *NOP t0
    +IADD.s32 r0:t1, u0.w0, r0
    *NOP t0
    +LOAD.i32.tl t1, r0, r1, @r0
}
clause_10:
ds(0) nbb tex ncph next_tex dwb(0)
{
    *FADD.f32 r9:t0, r1, r2
    +TEXC t1, t, t0, 0xf4186800, @r10
}
clause_11:
ds(0) nbb tex ncph
{
    *NOP t0
    +TEXC t1, t, t0, 0xf4186800, @r10
}
clause_12:
ds(0) nbb tex ncph
{
    *NOP t0
    +TEXC t1, t, t0, 0xf4186800, @r10
}
clause_13:
ds(0) nbb tex ncph
{
    *NOP t0
    +TEXC t1, t, t0, 0xf4186800, @r10
    *FMA.f32 r1:t0, r1, r2, r3
    +JUMP t1, clause_10
}
@message MESA_SHADER_COMPUTE shader: 10 inst, 8 tuples, 6 clauses, 2.000000 cycles, 1 threads, 1 loops, 2:5 spills:fills
@status 0
""".split("\n")

IR3 = """@gpu FD630
@variant plain.comp GROUP_SIZE=64
MESA: info: impl main {
MESA: info: Native code for unnamed CL shader GLSL2 with sha1 a5aa:
MESA: info: ; num_ubos:           0
MESA: info: @const(c5.x)	0x00000079
MESA: info: shps #l15
MESA: info: (rpt5)nop
MESA: info: (sy)(ss)shpe
MESA: info: l15:
MESA: info: (jp)(nop3) shl.b r1.z, r48.x, 6
MESA: info: l27:
MESA: info: isam (f32)(x)r6.y, r5.w, s#0, t#0
MESA: info: saml (f32)(x)r6.y, r5.w, r4.x, s#0, t#0
MESA: info: (rpt2)nop
MESA: info: ldp.u32 r0.x, p[r1.x], 1
MESA: info: jump #l27
MESA: info: (jp)end
MESA: info: nop
@message CL shader: 12 inst, 6 nops, 9 full, 0 stp, 1 ldp, 16 waves, 1 loops
@status 0
""".split("\n")

MALI = next(gpu for gpu in gpus.GPUS if gpu.name == "Mali-G52")
ADRENO = next(gpu for gpu in gpus.GPUS if gpu.name == "Adreno 630")


class DriverOutputTest(unittest.TestCase):
    def test_reads_gpu_variant_and_statistics(self):
        gpu, variants, errors = driver_output.read(BIFROST)
        self.assertEqual((gpu, errors, len(variants)), ("Mali-G52 (Panfrost)", [], 1))
        self.assertEqual(variants[0].shader, "align_residual.comp")
        self.assertEqual(variants[0].defines, {"PATCH_SIZE": 3})
        self.assertEqual(variants[0].numbers["inst"], 10)
        self.assertEqual((variants[0].numbers["spills"], variants[0].numbers["fills"]), (2, 5))

    def test_keeps_the_first_of_several_versions(self):
        lines = ["@variant a.vert", "@message VERT shader: 7 inst, 1 full", "@message BVERT shader: 3 inst, 1 full"]
        self.assertEqual(driver_output.read(lines)[1][0].numbers["inst"], 7)

    def test_says_what_does_not_compile(self):
        errors = driver_output.read(["@variant a.comp", "@error syntax error", "@status 1"])[2]
        self.assertEqual(errors, ["a.comp: syntax error", "a.comp: the driver said nothing"])

    def test_says_that_the_program_crashed(self):
        self.assertEqual(driver_output.read(["@status 139"])[2], ["compile_shaders ended with 139"])


class DisassemblyTest(unittest.TestCase):
    def steps(self, gpu, lines):
        variant = driver_output.read(lines)[1][0]
        return disassembly.read(gpu.compiler, variant.listing), variant

    def test_adds_up_to_the_drivers_counts(self):
        for gpu, lines in ((MALI, BIFROST), (ADRENO, IR3)):
            steps, variant = self.steps(gpu, lines)
            self.assertEqual(disassembly.disagreement(gpu.compiler, steps, variant.numbers), [])

    def test_sees_when_it_does_not_add_up(self):
        steps, variant = self.steps(ADRENO, IR3)
        faults = disassembly.disagreement("ir3", steps[:-1], variant.numbers)
        self.assertEqual(faults, ["inst: 11.000, driver 12.000"])

    def test_finds_the_loop_that_fetches(self):
        steps, _ = self.steps(MALI, BIFROST)
        counts = disassembly.total(disassembly.innermost_loop_with(steps, "texture"))
        self.assertEqual((counts["texture"], counts["tuples"], counts["memory"]), (4, 5, 0))
        self.assertEqual(disassembly.bifrost_cycles(counts), 2.0)

    def test_takes_the_whole_program_without_a_loop(self):
        steps, _ = self.steps(MALI, BIFROST)
        self.assertEqual(disassembly.innermost_loop_with(steps[:-1], "texture"), steps[:-1])

    def test_counts_scratch_memory(self):
        self.assertEqual(disassembly.total(self.steps(MALI, BIFROST)[0])["scratch"], 1)
        self.assertEqual(disassembly.total(self.steps(ADRENO, IR3)[0])["scratch"], 1)


def variant_with(name, **numbers):
    return driver_output.Variant(name, numbers, [])


class ChecksTest(unittest.TestCase):
    def test_finds_spills_on_the_gpus_that_count(self):
        variants = [variant_with("a.comp", spills=1, fills=2), variant_with("b.comp", spills=0, fills=0)]
        self.assertEqual(checks.check(MALI, variants, {}), ["Mali-G52: a.comp spills 3 times"])
        self.assertEqual(checks.check(gpus.GPUS[0], variants, {}), [])

    def test_compares_threads_with_the_yardstick(self):
        plain = variant_with("plain.comp GROUP_SIZE=64", threads=2)
        hot = variant_with("align_residual.comp GROUP_SIZE=128", threads=1)
        self.assertEqual(len(checks.check_threads(MALI, [hot, plain])), 1)
        hot.numbers["threads"] = 2
        self.assertEqual(checks.check_threads(MALI, [hot, plain]), [])

    def test_counts_waves_of_large_workgroups_twice(self):
        plain = variant_with("plain.comp GROUP_SIZE=64", waves=16)
        for group_size, waves, faults in ((64, 15, 1), (64, 16, 0), (128, 7, 1), (128, 8, 0)):
            hot = variant_with(f"align_residual.comp GROUP_SIZE={group_size}", waves=waves)
            self.assertEqual(len(checks.check_threads(ADRENO, [hot, plain])), faults)

    def test_compares_the_inner_loop_with_the_yardstick(self):
        costs = {"align_residual.comp": {"instructions": 151.0}, "plain.comp GROUP_SIZE=32": {"instructions": 100.0}}
        self.assertEqual(len(checks.check_loops(ADRENO, costs)), 1)
        costs["align_residual.comp"]["instructions"] = 149.0
        self.assertEqual(checks.check_loops(ADRENO, costs), [])

    def test_counts_pixels_by_what_a_fetch_brings(self):
        variant = driver_output.read(BIFROST)[1][0]
        cost = checks.loop_cost(MALI, variant)
        self.assertEqual((cost["pixels"], cost["tuples"], cost["cycles"]), (8, 5 / 8, 2 / 8))

    def test_does_not_judge_the_papers_plan(self):
        self.assertEqual(checks.check_spills(MALI, [variant_with("paper_solve.comp", spills=1)]), [])

    def test_notices_that_a_hot_kernel_was_renamed(self):
        self.assertEqual(len(checks.check_hot_kernels([variant_with("plain.comp")])), len(checks.HOT))


class ReportTest(unittest.TestCase):
    def test_shows_the_worst_variant_and_its_spills(self):
        numbers = ({"inst": 10, "cycles": 2.5, "threads": 2}, {"inst": 30, "cycles": 1, "threads": 1, "spills": 4})
        text = report.cell(MALI, [variant_with("a.comp", **n) for n in numbers])
        self.assertEqual(text, "30 / 2.5 / 1 / **4 spills**")

    def test_shows_the_dearest_pixel_of_a_shader(self):
        costs = {"a.comp X=1": {"instructions": 3.0, "pixels": 2}, "a.comp X=2": {"instructions": 5.0}, "b.comp": {"error": ""}}
        self.assertEqual(report.worst_costs(costs), {"a.comp": {"instructions": 5.0}, "b.comp": {}})

    def test_replaces_what_is_between_the_markers(self):
        page = f"head\n{report.BEGIN}\nold\n{report.END}\ntail\n"
        self.assertEqual(report.between_markers(page, "new"), f"head\n{report.BEGIN}\nnew\n{report.END}\ntail\n")
        with self.assertRaises(ValueError):
            report.between_markers("no markers", "new")


if __name__ == "__main__":
    unittest.main()
