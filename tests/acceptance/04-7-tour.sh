#!/usr/bin/env bash
# The two-minute tour of the README, pasted by a newcomer
tour=$(sed -n '/^## Two minutes/,/^## /p' "$root/README.md" | sed -n '1,/^## [^T]/p')
pictures=$(grep -oE '\]\(resources/[^)]*\.png\)' <<<"$tour" | tr -d '()]')
equal "pictures of the tour" "$(wc -w <<<"$pictures")" 5
for picture in $pictures; do [ -s "$root/$picture" ] || report FAIL "picture $picture" "is not there" "exists"; done
mkdir -p "$root/out"
pasted=0
while read -r line; do
  wanted=$(grep -oE -- '-o [^ ]+' <<<"$line" | cut -c4-)
  (cd "$root" && rm -f "$wanted" && PATH="$bin:$PATH" timeout 120 bash -c "$line") >>"$out/tour.log" 2>&1
  equal "${line:0:66}" "$? $([ -s "$root/$wanted" ] && echo made)" "0 made"
  pasted=$((pasted + 1))
done < <(sed -n '/^```sh/,/^```/p' <<<"$tour" | grep '^blossom ')
equal "commands of the tour" "$pasted" 5
