#!/usr/bin/env python3
"""Solves seeded random actions by the library's batch calls, in double and in float, and writes the joint values' bytes to
standard output. UHAS_INSTRUCTION_SET chooses the code that does it.

    solve_batch.py libuhas.so hand.h5 THREADS
"""
import ctypes
import sys

import numpy as np

ROWS = 1000


class BatchOptions(ctypes.Structure):  # uhas_batch_options
    _fields_ = [("struct_size", ctypes.c_size_t), ("threads", ctypes.c_int)]


def main():
    library, path, threads = sys.argv[1:]
    uhas = ctypes.CDLL(library)
    uhas.uhas_batch_row_size.restype = ctypes.c_size_t
    profile, batch = ctypes.c_void_p(), ctypes.c_void_p()
    assert uhas.uhas_profile_load(path.encode(), ctypes.byref(profile), None, ctypes.c_size_t(0)) == 0
    options = BatchOptions(ctypes.sizeof(BatchOptions), int(threads))
    assert uhas.uhas_batch_create(ctypes.byref(profile), ctypes.c_size_t(1), None, ctypes.byref(options), ctypes.byref(batch),
                                  None, ctypes.c_size_t(0)) == 0
    random = np.random.default_rng(5)
    wide = np.hstack([random.uniform(-0.5, 0.5, (ROWS, 5)), random.uniform(-2, 2, (ROWS, 10))])
    for solve, actions in ((uhas.uhas_batch_solve, wide), (uhas.uhas_batch_solve_f, wide.astype(np.float32))):
        q = np.zeros((ROWS, uhas.uhas_batch_row_size(batch)), actions.dtype)
        assert solve(batch, actions.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(actions.size), None, None,
                     q.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(q.size), None) == 0
        sys.stdout.buffer.write(q.tobytes())


if __name__ == "__main__":
    main()
