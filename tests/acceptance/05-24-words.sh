#!/usr/bin/env bash
# 24: the README, the manual and the help say what tests prove
counted=$("$root/tests/support/check_claims" "$root/tests/support/claims.txt" 2>&1 | tee "$out/claims.log" | tail -1)
equal "\"exact\", \"certified\", \"checked\", \"proved\" without a test" "$(grep -oE '[0-9]+ complaints' <<<"$counted")" "0 complaints"
at_least "places looked at" "$(grep -oE '^[0-9]+' <<<"$counted")" 20
strangers() { for sample in "$root"/resources/samples/*; do { unzip -p "$sample" document.json 2>/dev/null || cat "$sample"; } | grep -acE '"(/|[A-Za-z]:\\\\)[^"]*"'; done | awk '{ n += $1 } END { print n }'; }
at_most "paths of the machine they were made on in samples" "$(strangers)" 0
at_most "words on handles that the picture lacks" "$(grep -c 'and its handles' "$root/README.md")" 0
