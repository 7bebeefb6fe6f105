"""Estimate of a GPU backend from the simulator's counts and published data, in docs/performance.md."""

from figures import ruled

# NVIDIA A100, from the whitepaper of its architecture (2020) and the CUDA C++ Programming Guide for capability 8.0.
PROCESSORS = 108  # number of streaming multiprocessors
CLOCK = 1.41e9  # Hz
LANES = 64  # integer operations per clock and processor
SHARED_WIDTH = 128  # bytes per clock and processor
LINK = 31.5e9  # bytes per second over 16 lanes of PCI Express 4
# Clocks measured by Abdelkhalik and others, arXiv 2208.11174.
DEPENDENT = 4  # from an operation to a dependent one
SHARED_LATENCY = 23
L2_LATENCY = 200

# Our tile: a block of threads, each with a word of 32 pixels of every plane in shared memory.
THREADS = 64 * 64 // 32
CHAIN = 10  # dependent operations that classify a word by its corners, or a single pixel, after two shared-memory reads
STEP = 15  # operations of a word's bit step: sum and carry under E, and the next bits of F, for 32 pixels at once
STEP_BYTES = 12  # bytes of shared memory: two bits of each pixel are read, one is written
PICTURE = 12  # bytes per pixel sent to the host: depth, owner, colour
MEETING = 3 * L2_LATENCY  # clocks of a barrier over all blocks: increment, poll, and result

CORE_SECONDS = 40e-9  # per instruction and tile on one core, from the section What bounds it

SUBJECTS = (("carburettor", "512x512"), ("vehicle", "512x512"), ("house", "512x512"), ("carburettor", "2048x2048"))


def chain():
    """Clocks per instruction for a tile whose words are classified by corners; twice that for an open one."""
    return 2 * SHARED_LATENCY + CHAIN * DEPENDENT


def step_clocks():
    """Clocks of a bit step at a tile: limited by operations or by shared memory."""
    return max(STEP * THREADS / LANES, STEP_BYTES * THREADS / SHARED_WIDTH)


def counts(figures, model, size):
    return figures.runs.run(
        f"csgsim compile {figures.model(model)} --projection perspective --machine pixel-planes-4 --size {size} -o $OUT/program.csgt; "
        "csgsim_bench count --json $OUT/program.csgt >$OUT/counts.json").json("counts.json")


def pixels(size):
    width, height = size.split("x")
    return int(width) * int(height)


def seconds(work, dense):
    """Time on the GPU: limited by the longest tile of each stretch, or by all tiles on all processors."""
    if dense:
        longest, everything = work["longest_steps"] * step_clocks(), work["steps"] * step_clocks()
    else:
        longest = (work["longest"] + work["longest_open"]) * chain()
        everything = (work["instructions"] + work["open"]) * CHAIN * THREADS / LANES
    return (max(longest, everything / PROCESSORS) + work["stretches"] * MEETING) / CLOCK


def estimate(figures):
    head = ("model", "pixels", "tiles", "instructions at tiles", "side by side", "one core, ms", "GPU bit by bit, ms",
            "GPU by corners, ms", "equivalent cores", "picture to the host, ms")
    rows = []
    for model, size in SUBJECTS:
        work = counts(figures, model, size)
        core = work["instructions"] * CORE_SECONDS
        gpu = seconds(work, dense=False)
        rows.append((model, size.replace("x", " × "), work["tiles"], f"{work['instructions']:,}", f"{work['instructions'] / work['longest']:.1f}",
                     f"{core * 1e3:.1f}", f"{seconds(work, dense=True) * 1e3:.1f}", f"{gpu * 1e3:.1f}", f"{core / gpu:.0f}", f"{pixels(size) * PICTURE / LINK * 1e3:.1f}"))
    return ruled(head, rows, numbers_from=2)
