#include "scene/scene.h"

namespace blossom {

namespace {

Color hex(std::string_view text) { return *parseColor(text); }

}  // namespace

Color mixed(const Color& from, const Color& to, double t) {
  return {from.red + (to.red - from.red) * t, from.green + (to.green - from.green) * t,
          from.blue + (to.blue - from.blue) * t};
}

Look Look::dark() {
  Look look;
  look.backgroundTop = hex("#2b3038");
  look.backgroundBottom = hex("#1b1e23");
  look.made = hex("#f2a65a");
  look.madeFaces = look.made;
  look.control = hex("#8fb4ff");
  look.surface = hex("#b4bcc8");
  look.edge = hex("#3c424c");
  look.curve = hex("#c3cad6");
  look.grid = hex("#7f8896");
  look.fault = hex("#ef6f6c");
  return look;
}

Look Look::light() {
  Look look;
  look.backgroundTop = hex("#fbfbfa");
  look.backgroundBottom = hex("#e4e6ea");
  look.made = hex("#b35c0a");
  look.madeFaces = hex("#f0a45c");
  look.control = hex("#2f66d0");
  look.surface = hex("#aab4c3");
  look.edge = hex("#474f5c");
  look.curve = hex("#3b4350");
  look.grid = hex("#8b93a1");
  look.fault = hex("#c62f2f");
  return look;
}

}  // namespace blossom
