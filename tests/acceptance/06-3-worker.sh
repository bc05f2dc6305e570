#!/usr/bin/env bash
# The helper process that is kept: what further calls cost beside their kernel, and that nobody else notices
qtest "kept, ended, limited; the same bytes as from a new one" "$build/tests/bin/kept_worker_test"
for call in fillet boolean echo; do
  printf '      %s: %s ms with a new process\n' "$call" "$(figure kept_worker_test first_${call}_ms)"
  at_most "  the second of two equal calls, beside its kernel: $call" "$(figure kept_worker_test next_${call}_ms)" 10 ms
done
qtest "calls in a child process" "$build/tests/bin/worker_test"
qtest "names, colours and layers reach the other process and come back" "$build/tests/bin/shape_transport_test"
qtest "  assemblies with them" "$build/tests/bin/brep_transport_test"
qtest "signals end helpers that work and idle ones" "$build/tests/bin/interruption_test"
