"""The GPUs, and how Mesa's driver for each is made to compile without it (scripts/mobile_compilers.sh)."""
import dataclasses
import os
import pathlib
import subprocess

LIMIT_S = 3600  # a compiler that hangs must not hang us


@dataclasses.dataclass(frozen=True)
class Gpu:
    name: str
    number: str  # as the shim wants it
    compiler: str  # bifrost (and its successor Valhall), midgard or ir3
    disassemble: bool = False  # what the checks look at


GPUS = (
    Gpu("Mali-G31", "7093", "bifrost"),
    Gpu("Mali-G52", "7212", "bifrost", disassemble=True),
    Gpu("Mali-G52 r1", "7402", "bifrost"),
    Gpu("Mali-G57", "9093", "bifrost"),
    Gpu("Mali-G72", "6221", "bifrost"),
    Gpu("Mali-T860", "860", "midgard"),
    Gpu("Adreno 540", "540", "ir3"),
    Gpu("Adreno 618", "618", "ir3"),
    Gpu("Adreno 630", "630", "ir3", disassemble=True),
    Gpu("Adreno 660", "660", "ir3"),
)


def driver_environment(gpu):
    if gpu.compiler == "ir3":
        environment = {"FD_GPU_ID": gpu.number, "FD_MESA_DEBUG": "shaderdb"}
        if gpu.disassemble:
            environment["IR3_SHADER_DEBUG"] = "cs,vs,fs"
        return environment
    debug = "shaderdb,shaders" if gpu.disassemble else "shaderdb"
    return {
        "PAN_GPU_ID": gpu.number,
        "PAN_MESA_DEBUG": "shaderdb",
        "BIFROST_MESA_DEBUG": debug,
        "MIDGARD_MESA_DEBUG": "shaderdb",
    }


def compile_shaders(gpu, cache, glob):
    """Yields the lines that compile_shaders and the driver print; the last one is "@status N"."""
    family = "freedreno" if gpu.compiler == "ir3" else "panfrost"
    shim = pathlib.Path(cache) / "shims" / f"lib{family}_noop_drm_shim.so"
    command = ["qemu-aarch64-static", "-E", f"LD_PRELOAD={shim}", str(pathlib.Path(cache) / "program/compile_shaders")]
    environment = {
        **{key: value for key, value in os.environ.items() if not key.startswith(("MESA_", "EGL_", "LIBGL_", "GALLIUM_"))},
        **driver_environment(gpu),
        "QEMU_LD_PREFIX": str(pathlib.Path(cache) / "sysroot"),
        "MESA_SHADER_CACHE_DISABLE": "true",
    }
    with subprocess.Popen(
        ["timeout", str(LIMIT_S), *command, glob],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,  # drivers print to both
        text=True,
        errors="replace",
    ) as process:
        for line in process.stdout:
            yield line.rstrip("\n")
        yield f"@status {process.wait()}"
