#!/usr/bin/env bash
# Curves survive sums, differences and morphs
tests=$build/tests/bin
qtest "Steiner's formula, rounded outlines beside fine polygons, free-form ones" "$tests/minkowski_curves_test"

# A triangle morphs into a circle: lines and true arcs only, and the area of the mixed volumes at every t.
wrong=0 worst=0
for k in $(seq 1 50); do
  t=$(awk -v k="$k" 'BEGIN { printf "%.10f", k / 51 }')
  result=$("$bin/blossom" morph polygon:3:20 circle:10 --t "$t" --json 2>/dev/null)
  kinds="$(json lines <<<"$result") $(json arcs <<<"$result") $(json splines <<<"$result")"
  [ "$kinds" = "3 3 0" ] || wrong=$((wrong + 1))
  worst=$(awk -v t="$t" -v a="$(json area <<<"$result")" -v worst="$worst" 'BEGIN {
    pi = atan2(0, -1); side = 20 * sqrt(3); triangle = sqrt(3) / 4 * side * side
    exact = (1 - t) ^ 2 * triangle + (1 - t) * t * 3 * side * 10 + t * t * pi * 100
    d = a / exact - 1; if (d < 0) d = -d; printf "%.2e", (d > worst) ? d : worst }')
done
equal "a triangle becomes a circle at 50 t: other than 3 lines and 3 arcs" "$wrong" 0
at_most "  area, relative" "$worst" 1e-12

worst=0
for pair in "3 1" "0.02 0.7" "1000 3" "5 1000"; do
  read -r s r <<<"$pair"
  area=$("$bin/blossom" minkowski-sum "rectangle:$s:$s" "circle:$r" --json 2>/dev/null | json area)
  worst=$(awk -v s="$s" -v r="$r" -v a="$area" -v worst="$worst" 'BEGIN {
    d = a / (s * s + 4 * s * r + atan2(0, -1) * r * r) - 1; if (d < 0) d = -d; printf "%.2e", (d > worst) ? d : worst }')
done
at_most "square and disc: area against s^2 + 4 s r + pi r^2, relative" "$worst" 1e-12

# A ring as files have it: circles in arcs that are closed by a line without length.
"$bin/blossom" boolean circle:20 circle:10 --operation difference -o "$out/ring.svg" >/dev/null 2>&1
result=$("$bin/blossom" minkowski-sum "$out/ring.svg" circle:2 --json 2>/dev/null)
equal "a ring from an SVG file and a disc: lines and arcs" "$(json lines <<<"$result") $(json arcs <<<"$result")" "0 2"
at_most "  area, relative" "$(awk -v a="$(json area <<<"$result")" 'BEGIN { d = a / (atan2(0, -1) * 420) - 1; printf "%.2e", d < 0 ? -d : d }')" 1e-12

qtest "loops that touch one another keep their arcs; the room of discs nearly as large" "$tests/minkowski_touching_test"

# What is handed on: OpenCASCADE's measure of the face in the STEP file.
"$bin/blossom" minkowski-sum star:5:20:8 circle:3 -o "$out/rounded-star.step" --json >"$out/rounded-star.json" 2>/dev/null
equal "a star and a disc as STEP: area in the file" "$("$bin/blossom" info "$out/rounded-star.step" --json | json area | xargs printf '%.9g')" \
  "$(json area <"$out/rounded-star.json" | xargs printf '%.9g')"
kinds=$("$bin/blossom" morph text:a text:g --t 0.5 --json 2>/dev/null)
at_most "a letter on the way to another: segments" "$(json vertices <<<"$kinds")" 60
at_least "  splines among them" "$(json splines <<<"$kinds")" 10

# The sum alone, without the start of the program.
result=$("$bin/blossom" minkowski-sum star:2000:20:8 circle:1 --json)
at_most "star of 2000 points and a disc" "$(json kernel_ms <<<"$result")" 300 ms
memory=$({ /usr/bin/time -f '%M' "$bin/blossom" minkowski-sum star:2000:20:8 circle:1 --json >/dev/null; } 2>&1 | tail -1)
at_most "  memory" "$((memory / 1024))" 200 MB
