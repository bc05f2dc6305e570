#!/usr/bin/env bash
# Number 2: steps are nested under what is final; a failing feature keeps the last good shape
qtest "the tree: nested steps, folds, filter, moves, opening at the top" "$build/tests/bin/nested_tree_test"
qtest "the tree: search, suppress, reorder" "$build/tests/bin/document_tree_test"
qtest "a failing feature keeps its last shape, marked" "$build/tests/bin/stepping_back_test"
