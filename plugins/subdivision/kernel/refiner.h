#pragma once
#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

#include "geometry/mesh/mesh.h"
#include "kernel/scheme.h"

// OpenSubdiv shows in this header and in the two files that include it, nowhere else.
namespace blossom::subdivision {

/// The OpenSubdiv topology of a cage accepted by `checkCage`, with its sharp edges and vertices. The boundary rule is the
/// tag `t interpolateboundary 1/0/0 N` of the cage: 1, the default, keeps corners of the boundary; 2 rounds them. `t
/// creasemethod` with "chaikin" averages the sharpness of creases.
/// @throws Error InvalidInput for another N.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> makeRefiner(const Mesh&, Scheme);

}  // namespace blossom::subdivision
