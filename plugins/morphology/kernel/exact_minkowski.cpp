// First, because the headers after it undefine debugging macros that it needs.
#include "kernel/exact_types.h"

#include <CGAL/minkowski_sum_3.h>

namespace blossom::morphology {

namespace {

Nef scaledNef(const Solid& solid, double factor) {
  Nef nef = nefOf(*solid);
  if (factor != 1) nef.transform(Exact::Aff_transformation_3(CGAL::SCALING, Exact::RT(factor)));
  return nef;
}

}  // namespace

Solid minkowskiSum(const Solid& a, double factorA, const Solid& b, double factorB, const Progress& progress) {
  progress.report(0, "Adding Nef polyhedra");
  Nef first = scaledNef(a, factorA), second = scaledNef(b, factorB);
  return solidFrom(CGAL::minkowski_sum_3(first, second));
}

}  // namespace blossom::morphology
