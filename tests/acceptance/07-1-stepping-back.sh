#!/usr/bin/env bash
# Number 1: what is used up steps back
qtest "what goes into a result, by what feature types declare" "$build/tests/bin/shown_features_test"
qtest "in the window: chains, cuts, controls of a morph, failures" "$build/tests/bin/stepping_back_test"
