#!/usr/bin/env bash
# Number 7: Recompute, a cross that stays in place, progress by work done, refusals in the log
qtest "progress by the time that features took, results forgotten" "$build/tests/bin/evaluator_test"
qtest "in the window: F5, the cross, the log" "$build/tests/bin/jobs_and_log_test"
