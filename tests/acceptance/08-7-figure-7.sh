#!/usr/bin/env bash
# Fig. 7: the propeller by hand in the window, the stages as samples, and the way there as frames
tests=$build/tests/bin
pictures=$out/figure-7
rm -rf "$pictures" && mkdir -p "$pictures"
qtest "made from an empty document by X events, saved as a motion; the samples open; scrubbed" "$tests/sweep_figure_test" BLOSSOM_PICTURES="$pictures"
off() { awk -v a="${1:-0}" -v b="${2:-1}" 'BEGIN { print (a > b ? a - b : b - a) / b }'; } # of two volumes, as a share

# The motion that was saved from the window
swept=$("$bin/blossom" sweep "$pictures/figure-7.json" --solid -o "$pictures/figure-7.step" --json 2>"$out/figure.log" | json volume)
shipped=$("$bin/blossom" sweep "$root/resources/samples/propeller.json" --solid -o "$pictures/shipped.step" --json 2>>"$out/figure.log" | json volume)
stage=$("$bin/blossom" sweep "$root/resources/samples/propeller-f-twisted.blossom#sweep-twist-4" --solid -o "$pictures/stage-f.step" --json 2>>"$out/figure.log" | json volume)
at_most "swept on the command line: volume off that in our reader of STEP" "$(off "$("$bin/blossom" info "$pictures/figure-7.step" --json | json volume)" "$swept")" 1e-9
checked=$("$tests/check_solid" "$pictures/figure-7.step" 2>>"$out/figure.log")
equal "  one solid, closed and valid by OCCT's own check" "$(json solids <<<"$checked"), $(json valid <<<"$checked")" "1, true"
at_most "  volume off that of OCCT's reader, span by span" "$(off "$(json volume_by_spans <<<"$checked")" "$swept")" 1e-9
at_most "  volume off OCCT's own integration, for the record" "$(off "$(json volume <<<"$checked")" "$swept")" 1e-4
at_most "  volume off that of the sample propeller.json" "$(off "$swept" "$shipped")" 0.02
at_most "  volume off that of the sample of the last stage" "$(off "$swept" "$stage")" 0.02
equal "pictures of the stages a to f by hand, and of their samples" "$(ls "$pictures"/figure-7-[a-f].png 2>/dev/null | wc -l), $(ls "$pictures"/sample-propeller-[a-f]-*.png 2>/dev/null | wc -l)" "6, 6"

# The way there as frames
qtest "growth: ways of pulls and twists, frames on the ends of edits, the last one bit for bit" "$tests/sweep_growth_test"
at_most "  places off the straight way to their targets, share of the size" "$(figure sweep_growth_test growth_off_the_way_share)" 1e-12
"$bin/blossom" convert "$root/resources/samples/propeller-growing.blossom" -o "$pictures/frame.stl" --json >"$out/frames.log" 2>&1
equal "frames of a cylinder that becomes a propeller" "$(ls "$pictures"/frame*.stl 2>/dev/null | wc -l)" 25
echo "      look at them in ${pictures#"$root"/}"
