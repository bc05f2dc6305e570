#!/usr/bin/env bash
# The propeller, exact, as STEP and IGES: checked by a program that shares no code with the kernel
motion=${BLOSSOM_ACCEPT_MOTION:-$root/resources/samples/propeller.json}
check() { "$build/tests/bin/check_sweep" "$motion" "$@" 2>&1; }
"$bin/blossom" sweep "$motion" -o "$out/p.step" --json >"$out/p.json"
result=$(check "$out/p.step" 10000)
equal "STEP: degree in u x v" "$(json degree_u <<<"$result")x$(json degree_v <<<"$result")" 9x12
equal "STEP: rational B-spline" "$(json rational <<<"$result")" true
at_most "STEP: distance to M(u,v)p at 10,000 parameters" "$(json max_error <<<"$result")" 1e-9 mm
"$bin/blossom" sweep "$motion" -o "$out/p.igs" --json >/dev/null
at_most "IGES: the same" "$(check "$out/p.igs" 10000 | json max_error)" 1e-8 mm
cubic=$("$bin/blossom" sweep "$motion" --mode cubic --tolerance 1e-3 -o "$out/c.step" --json)
result=$(check "$out/c.step" 10000)
equal "cubic: degree in u x v" "$(json degree_u <<<"$result")x$(json degree_v <<<"$result")" 3x3
at_most "cubic: distance at 10,000 parameters, --tolerance 1e-3" "$(json max_error <<<"$result")" 1e-3 mm
at_most "cubic: deviation it claims" "$(json deviation <<<"$cubic")" 1e-3 mm
"$bin/blossom" sweep "$motion" --solid -o "$out/s.step" --json >"$out/s.json"
"$bin/blossom" sweep "$motion" --solid -o "$out/s.stl" --chord 0.01 --json >/dev/null
result=$("$build/tests/bin/check_solid" "$out/s.step" "$out/s.stl" 0.01)
equal "solid: closed and valid by OCCT's own check" "$(json valid <<<"$result")" true
at_most "solid: |volume - its mesh's volume| / (area * deflection 0.01)" "$(json volume_ratio <<<"$result")" 1
