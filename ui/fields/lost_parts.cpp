#include "ui/fields/lost_parts.h"

#include <algorithm>
#include <cmath>

namespace blossom::ui {

namespace {

/// Nothing when the document does not tell what it looked like.
std::optional<Likeness> rememberedOf(const Value& part) {
  try {
    return likenessFrom(part.at("signature").at("likeness"));
  } catch (const Value::exception&) {
    return std::nullopt;
  }
}

/// How far apart two parts are in mm; the sizes of faces are areas.
double apart(const Likeness& a, const Likeness& b, bool areas) {
  const double sizes = areas ? std::sqrt(a.size) - std::sqrt(b.size) : a.size - b.size;
  return (a.place - b.place).norm() + std::abs(sizes);
}

double reachOf(const Likeness& part, bool area) { return (area ? std::sqrt(part.size) : part.size) / 2; }

}  // namespace

bool isLost(const Value& part, const std::vector<Value>& lost) {
  return std::find(lost.begin(), lost.end(), part) != lost.end();
}

std::optional<std::size_t> lostPartFor(const Likeness& picked, const Value& parts, const std::vector<Value>& lost) {
  std::optional<std::size_t> nearest;
  double least = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto before = isLost(parts[k], lost) ? rememberedOf(parts[k]) : std::nullopt;
    if (!before || before->form != picked.form) continue;
    const bool areas = parts[k].value("kind", std::string()) == "face";
    if ((before->place - picked.place).norm() > std::max(reachOf(*before, areas), reachOf(picked, areas))) continue;
    const double distance = apart(*before, picked, areas);
    if (nearest && distance >= least) continue;
    nearest = k;
    least = distance;
  }
  return nearest;
}

}  // namespace blossom::ui
