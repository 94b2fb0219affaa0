"""What the paper reports (its tables of frame times, GPU stages, direct share and accuracy)."""

DEVICES = ("laptop", "Nano", "Radxa")

# Per sequence and device in the order of DEVICES.
FRAME_MS = {  # median frame time: ORB-SLAM2, GLidE-SLAM
    "tum3": ((9.6, 5.0), (31.1, 4.8), (131.0, 58.8)),
    "tum2_desk": ((9.9, 5.1), (32.8, 3.6), (132.0, 64.3)),
    "tum2_xyz": ((8.5, 3.8), (29.2, 3.1), (127.0, 43.9)),
    "MH01": ((10.9, 3.9), (35.4, 6.2), (136.0, 107.4)),
    "MH03": ((9.9, 11.9), (33.4, 32.6), (135.0, 180.5)),
    "MH05": ((9.2, 3.4), (30.8, 6.9), (124.0, 127.0)),
}
GPU_MS = {  # Pre = pyramid + precompute, Trk = pyramid + track
    "tum3": ((2.5, 3.5), (2.0, 2.8), (43.7, 39.1)),
    "tum2_desk": ((2.5, 3.6), (2.1, 2.8), (43.7, 38.9)),
    "tum2_xyz": ((2.6, 3.4), (2.0, 2.7), (51.0, 40.8)),
    "MH01": ((1.6, 2.6), (2.7, 3.9), (69.5, 46.4)),
    "MH03": ((2.3, 3.0), (2.7, 3.9), (68.0, 45.6)),
    "MH05": ((1.1, 1.9), (2.8, 3.8), (67.3, 45.7)),
}
DIRECT_PERCENT = {
    "tum3": (69.3, 68.5, 69.0),
    "tum2_desk": (70.1, 70.3, 69.2),
    "tum2_xyz": (89.9, 89.8, 89.8),
    "MH01": (63.6, 63.9, 65.3),
    "MH03": (46.1, 45.0, 46.5),
    "MH05": (61.3, 61.2, 60.3),
}
ATE_M = {  # RMSE: ORB-SLAM2, GLidE-SLAM
    "tum3": ((0.010, 0.014), (0.012, 0.021), (0.009, 0.016)),
    "tum2_desk": ((0.008, 0.010), (0.013, 0.008), (0.006, 0.016)),
    "tum2_xyz": ((0.002, 0.002), (0.002, 0.002), (0.002, 0.003)),
    "MH01": ((0.046, 0.044), (0.045, 0.048), (0.036, 0.042)),
    "MH03": ((0.038, 0.040), (0.040, 0.039), (0.032, 0.038)),
    "MH05": ((0.056, 0.075), (0.051, 0.053), (0.037, 0.048)),
}
SEQUENCES = tuple(FRAME_MS)


def as_json():
    """All of it, device by device."""
    def pairs(table, first, second):
        return {key: {device: {first: pair[0], second: pair[1]} for device, pair in zip(DEVICES, row)}
                for key, row in table.items()}

    return {
        "frame_ms": pairs(FRAME_MS, "orb_slam2", "glide"),
        "gpu_ms": pairs(GPU_MS, "pre", "trk"),
        "direct_percent": {key: dict(zip(DEVICES, row)) for key, row in DIRECT_PERCENT.items()},
        "ate_m": pairs(ATE_M, "orb_slam2", "glide"),
    }
