#pragma once
// Not named features.h: the C library has a header of that name, which the plugin's include folder would hide.
#include "feature/registry.h"

namespace blossom::modeling {

/// Register the feature types of one group each.
void registerOutlines(Registry&);
void registerPrimitives(Registry&);        ///< box, cylinder, cone, sphere, torus
void registerProfileFeatures(Registry&);   ///< extrude, revolve, loft, pipe
void registerSolidFeatures(Registry&);     ///< Boolean, fillet, chamfer, shell, solid from mesh
void registerArrangements(Registry&);      ///< transform, pattern, mirror
void registerSequenceFeatures(Registry&);  ///< frame, join sequences, retime

/// An angle of up to one full turn in either direction.
ParameterSpec turn();

}  // namespace blossom::modeling
