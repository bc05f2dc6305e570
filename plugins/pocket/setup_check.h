#pragma once
#include "feature/feature_type.h"
#include "geometry/shape/setup.h"
#include "geometry/shape/toolpath.h"
#include "kernel/setup/tool_stages.h"

namespace blossom::pocket {

/// What carries the cutter; lengths in mm, 0: not known.
struct HolderParameters {
  double fluteLength = 0, shankDiameter = 0, stickOut = 0, holderDiameter = 0, holderLength = 0;
};

ToolAssembly assemblyOf(const Cutter&, const HolderParameters&);

/// Declares the parameters of a holder; they mean something where a setup is given. P: a struct derived from
/// HolderParameters.
template <class P>
FeatureBuilder<P>& withHolder(FeatureBuilder<P>& type) {
  const auto add = [&](const char* name, double HolderParameters::*member, const char* help) {
    type.parameter(name, static_cast<double P::*>(member), onlyWith(lengthFromZero(), "setup"), help);
  };
  add("flute-length", &HolderParameters::fluteLength, "Length of the flutes; 0: the shank is not checked.");
  add("shank-diameter", &HolderParameters::shankDiameter, "Diameter of the shank above the flutes; 0: not checked.");
  add("stick-out", &HolderParameters::stickOut, "From the tip to the holder; 0: the holder is not checked.");
  add("holder-diameter", &HolderParameters::holderDiameter, "Diameter of the holder; 0: not checked.");
  add("holder-length", &HolderParameters::holderLength, "Length of the holder; 0: without end.");
  return type;
}

/// What a program runs into.
struct SetupFindings {
  std::size_t collisions = 0;      ///< moves during which a part of the tool is where it must not be
  std::size_t outside = 0;         ///< moves that leave the machine's travel
  double removed = 0;              ///< mm3 of the stock, as a field of heights tells
  std::vector<ToolMark> marks;     ///< first contacts
  std::vector<std::string> told;   ///< full sentences, the worst first
  std::vector<std::string> notes;  ///< what was not looked at
};

/// Sweeps the flutes, the shank and the holder along every move against the part and the clamps of a setup, in whose
/// coordinates the program is, carves the stock, through which no rapid, shank or holder may go, and compares the places of
/// the tip with the machine's travel.
/// @param allowed mm, how deep the tool may enter the part; twice the chord of its triangles comes to it
/// @throws Error InvalidParameter (a tool that cannot be), Cancelled.
SetupFindings findingsIn(const Setup&, const Toolpath&, const ToolAssembly&, double allowed, const Progress&);

}  // namespace blossom::pocket
