# SPDX-License-Identifier: MIT
"""Reads what ctest tells as bench/gpu does. usage: gpu_test.py BENCH_GPU"""
import importlib.machinery
import importlib.util
import sys
import unittest

LOADER = importlib.machinery.SourceFileLoader("bench_gpu", sys.argv.pop(1))
GPU = importlib.util.module_from_spec(importlib.util.spec_from_loader("bench_gpu", LOADER))
LOADER.exec_module(GPU)

HEAD = """      Start 509: gl
 1/13 Test #509: gl ...............................***Exception: SegFault  1.94 sec
 2/13 Test #510: render ...........................   Passed    1.94 sec

"""
FAILED = HEAD + """69% tests passed, 4 tests failed out of 13

Total Test time (real) =   3.90 sec

The following tests did not run:
	500 - witness (Skipped)

The following tests FAILED:
	509 - gl (SEGFAULT)
	511 - lab (Failed)
	512 - techniques:shadow (Timeout)
	520 - cli (Child aborted)
Errors while running CTest
"""


class Ctest(unittest.TestCase):
    def test_every_way_to_fail_is_a_failure(self):
        self.assertEqual(GPU.read_tests(FAILED), {"run": 13, "failed": ["gl", "lab", "techniques:shadow", "cli"]})

    def test_all_passed(self):
        self.assertEqual(GPU.read_tests("100% tests passed, 0 tests failed out of 13\n"), {"run": 13, "failed": []})

    def test_what_does_not_add_up_is_no_result(self):
        self.assertIsNone(GPU.read_tests("No tests were found!!!\n"))
        self.assertIsNone(GPU.read_tests(FAILED.replace("4 tests failed", "5 tests failed")))


if __name__ == "__main__":
    unittest.main()
