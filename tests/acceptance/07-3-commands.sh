#!/usr/bin/env bash
# Number 3: selection is the command's first input
qtest "edges before Fillet, questions in the view, what leaves no choice" "$build/tests/bin/command_start_test"
