#!/usr/bin/env python3
"""8. A policy loop over 4,096 hands, from Python: ctypes and NumPy, no binding to build.

    ./08_policy_loop.py libuhas.so hand.h5
"""

import ctypes
import sys
import time

import numpy as np

HANDS, PERIODS, DT = 4096, 20, 0.02


class ControllerOptions(ctypes.Structure):  # uhas_controller_options
    _fields_ = [("struct_size", ctypes.c_size_t), ("velocity_scale", ctypes.c_double), ("range_scale", ctypes.c_double),
                ("time_constant", ctypes.c_double), ("solve", ctypes.c_void_p)]


class BatchOptions(ctypes.Structure):  # uhas_batch_options
    _fields_ = [("struct_size", ctypes.c_size_t), ("threads", ctypes.c_int)]


def create(function, *arguments):
    """The handle that a load or create function makes."""
    handle, message = ctypes.c_void_p(), ctypes.create_string_buffer(256)
    if function(*arguments, ctypes.byref(handle), message, ctypes.c_size_t(len(message))) != 0:
        sys.exit(f"08_policy_loop: error: {message.value.decode()}")
    return handle


def call(function, *arguments):
    """A call that returns a status; an array goes as its address and its size, as uhas.h wants it."""
    flat = []
    for argument in arguments:
        if isinstance(argument, np.ndarray):
            flat += [argument.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(argument.size)]
        else:
            flat.append(argument)
    status = function(*flat)
    if status != 0:
        sys.exit(f"08_policy_loop: error: {uhas.uhas_status_text(status).decode()}")


if len(sys.argv) != 3:
    sys.exit("usage: 08_policy_loop.py libuhas.so hand.h5")
uhas = ctypes.CDLL(sys.argv[1])
uhas.uhas_status_text.restype = ctypes.c_char_p
for counter in (uhas.uhas_profile_joint_count, uhas.uhas_observer_size):
    counter.restype = ctypes.c_size_t

profile = create(uhas.uhas_profile_load, sys.argv[2].encode())
options = ControllerOptions(ctypes.sizeof(ControllerOptions), 1.0, 0.95, 0.05, None)
controller = create(uhas.uhas_controller_create, profile, ctypes.byref(options))
profiles = (ctypes.c_void_p * 1)(profile)  # several hands, if you like: see `hands` in uhas_batch_solve
threads = BatchOptions(ctypes.sizeof(BatchOptions), 2)
batch = create(uhas.uhas_batch_create, profiles, ctypes.c_size_t(1), None, ctypes.byref(threads))
observer = create(uhas.uhas_observer_create, profile, None)

# float32, C order, one row a hand; made once and filled in place
joints = uhas.uhas_profile_joint_count(profile)
q = np.zeros((HANDS, joints), np.float32)
qd = np.zeros_like(q)
solutions = np.zeros_like(q)
targets = np.zeros_like(q)
observations = np.zeros((HANDS, uhas.uhas_observer_size(observer)), np.float32)

reference = np.zeros(joints)
call(uhas.uhas_profile_reference_posture, profile, reference)
q[:] = reference
call(uhas.uhas_controller_reset_f, controller, q, targets, None)

# a policy: any map from observations to 15 numbers; the same one serves every hand that has a profile
random = np.random.default_rng(0)
weights = random.normal(0, 0.05, (observations.shape[1], 15)).astype(np.float32)

spent = 0.0
for period in range(PERIODS):
    start = time.perf_counter()
    call(uhas.uhas_observer_observe_f, observer, q, qd, observations, None)
    spent += time.perf_counter() - start

    actions = np.tanh(observations @ weights + random.normal(0, 0.3, (HANDS, 15)).astype(np.float32))

    start = time.perf_counter()
    call(uhas.uhas_batch_solve_f, batch, actions, None, None, solutions, None)
    call(uhas.uhas_controller_approach_f, controller, solutions, ctypes.c_float(DT), targets, None)
    spent += time.perf_counter() - start

    qd[:] = (targets - q) * np.float32(0.8 / DT)  # the simulator: joints follow their targets
    q += qd * np.float32(DT)

print(f"{HANDS} hands, {PERIODS} periods: {1e9 * spent / HANDS / PERIODS:.0f} ns a hand and period in uhas")
print("the first hand stands at", np.array2string(q[0], precision=3, suppress_small=True))

uhas.uhas_observer_free(observer)
uhas.uhas_batch_free(batch)
uhas.uhas_controller_free(controller)
uhas.uhas_profile_free(profile)
