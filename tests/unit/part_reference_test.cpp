// Faces and edges that a feature names are found again after edits of what it is made of, or told to be lost; never others.
#include <algorithm>
#include <numbers>

#include "document/part_references.h"
#include "support/part_models.h"
#include "support/picked_parts.h"

using namespace blossom;
using namespace blossom::test;

namespace {

struct Counts {
  int edits = 0, found = 0, lost = 0, gone = 0, wrong = 0;
};

}  // namespace

class PartReferenceTest : public QObject {
  Q_OBJECT
 private slots:
  void partsAreFoundAfterRandomEdits();
  void anInsertedCornerMovesNoFillet();
  void documentsWithoutSignaturesUseNumbers();
  void damagedSignaturesLoseThePart();
  void parametersKeepSignatures();

 private:
  /// The construction and a feature after it that names the part.
  static Document naming(const Model& model, const Value& part) {
    const Document document = model.construction();
    const FeatureId last = document.features().back()->id;
    const char* const list = model.kind() == SubShapeKind::Face ? "faces" : "edges";
    return with(document, "hold", "hold", {{list, Value::array({part})}}, {last});
  }
  static Value numbered(SubShapeKind kind, int number) {
    return {{"input", "shape"}, {"kind", subShapeKindName(kind)}, {"index", number}};
  }
  static const Value& partIn(const FeatureResult& result) { return result.parts.begin().value().at(0); }
  static bool tryOne(Model& model, Random& random, Counts& counts);
  static void keepRounding(Rounded& model);
};

/// The rounding of the model itself is kept as a document keeps it.
void PartReferenceTest::keepRounding(Rounded& model) {
  model.edges_ = Value::array();
  const Results plain = evaluated(model.construction());
  const auto number = numberAt(plain.at("prism")->evaluated.shape, SubShapeKind::Edge, model.roundedAt());
  QVERIFY(number.has_value());
  model.edges_ = Value::array({numbered(SubShapeKind::Edge, *number)});
  model.edges_ = evaluated(model.construction()).at("rounded")->parts.at("edges");
}

/// False when the edit left nothing to go on with: an outline that crosses itself.
bool PartReferenceTest::tryOne(Model& model, Random& random, Counts& counts) {
  model.pick(random);
  auto* const rounded = dynamic_cast<Rounded*>(&model);
  if (rounded) keepRounding(*rounded);
  const Document before = model.construction();
  const FeatureId last = before.features().back()->id;
  const Results first = evaluated(before);
  if (first.at(last)->error) return false;
  const auto number = numberAt(first.at(last)->evaluated.shape, model.kind(), *model.place());
  if (!number) return true;  // two parts at one place, which can be picked in no other way either
  const FeatureId holder = "hold";
  const Value signedPart = partIn(*evaluated(naming(model, numbered(model.kind(), *number))).at(holder));
  const SubShapeKind kind = model.kind();

  const std::string edit = model.edit(random);
  const Results results = evaluated(naming(model, signedPart));
  const FeatureResult& after = *results.at(holder);
  if (results.at(last)->error) return false;
  const std::optional<Vec3> place = model.place();
  const auto truth = place ? numberAt(results.at(last)->evaluated.shape, kind, *place) : std::nullopt;
  const bool lost = after.error && after.error->message().find(" lost: ") != std::string::npos;
  ++counts.edits;
  if (!truth) {
    ++counts.gone;
    if (place) return true;  // it was cut in two
    if (!lost) ++counts.wrong;
    if (!lost)
      qWarning("%s: %s is gone, %s was taken", edit.c_str(), signedPart.dump().c_str(), partIn(after).dump().c_str());
    return true;
  }
  if (lost) {
    ++counts.lost;
    qInfo("lost by \"%s\": %s", edit.c_str(), signedPart.at("signature").at("faces").dump().c_str());
  } else if (after.parts.empty() || partIn(after).at("index") != *truth) {
    ++counts.wrong;
    qWarning("%s: %s, true %d", edit.c_str(), after.parts.dump().c_str(), *truth);
  } else {
    ++counts.found;
  }
  return true;
}

void PartReferenceTest::partsAreFoundAfterRandomEdits() {
  Random random = test::seededRandom();
  const int each = qEnvironmentVariableIsSet("BLOSSOM_TEST_EDITS") ? qEnvironmentVariableIntValue("BLOSSOM_TEST_EDITS") : 17;
  Counts all;
  const std::vector<std::pair<const char*, std::function<std::unique_ptr<Model>()>>> models{
      {"prism", [] { return std::make_unique<Prism>(); }},       {"drilled", [] { return std::make_unique<Drilled>(); }},
      {"turned", [] { return std::make_unique<Turned>(); }},     {"rounded", [] { return std::make_unique<Rounded>(); }},
      {"mirrored", [] { return std::make_unique<Mirrored>(); }}, {"row", [] { return std::make_unique<Row>(); }}};
  for (const auto& [name, make] : models) {
    Counts counts;
    std::unique_ptr<Model> model;
    bool good = false;
    for (int k = 0; k < 4 * each && counts.edits < each; ++k) {
      if (k % 4 == 0 || !good) model = make();  // edits add up for a while
      good = tryOne(*model, random, counts);
    }
    qInfo("%-8s %3d edits: %3d found, %2d lost, %2d gone, %d wrong", name, counts.edits, counts.found, counts.lost,
          counts.gone, counts.wrong);
    all.edits += counts.edits;
    all.found += counts.found;
    all.lost += counts.lost;
    all.gone += counts.gone;
    all.wrong += counts.wrong;
  }
  const double share = static_cast<double>(all.found) / std::max(1, all.found + all.lost + all.wrong);
  qInfo("all: %d edits, found %.4f of those that exist, %d lost, %d gone, %d wrong", all.edits, share, all.lost, all.gone,
        all.wrong);
  QCOMPARE(all.wrong, 0);
  QVERIFY(share >= 0.9);
  QVERIFY(all.edits >= each * 4);
}

// A fillet of one corner hopped to another when a corner was inserted before it.
void PartReferenceTest::anInsertedCornerMovesNoFillet() {
  Corners corners({{0, 0}, {60, 0}, {60, 40}, {0, 40}});
  const auto document = [&](const Value& edges) {
    Document made =
        with(with({}, "outline", "outline", corners.parameters()), "prism", "extrude", {{"height", 20}}, {"outline"});
    return with(made, "fillet", "fillet", {{"radius", 5}, {"edges", edges}}, {"prism"});
  };
  const Results plain = evaluated(document(Value::array()));
  const auto number = numberAt(plain.at("prism")->evaluated.shape, SubShapeKind::Edge, {60, 40, 10});
  QVERIFY(number.has_value());
  const Results first = evaluated(document(Value::array({numbered(SubShapeKind::Edge, *number)})));
  const Value kept = first.at("fillet")->parts.at("edges");
  corners.insert(0, 0.2);
  const Results second = evaluated(document(kept));
  QVERIFY(!second.at("fillet")->error);
  const double piece = (1 - std::numbers::pi / 4) * 25 * 20;
  const double solid = test::figure(second.at("prism")->evaluated.shape, "volume");
  const double volume = test::figure(second.at("fillet")->evaluated.shape, "volume");
  QVERIFY(std::abs(solid - volume - piece) < 1e-6);  // a corner of 90 degrees; the new ones are not
  QVERIFY(second.at("fillet")->parts.at("edges").at(0).at("index") != *number);
}

void PartReferenceTest::documentsWithoutSignaturesUseNumbers() {
  const Prism prism;
  const Results results = evaluated(naming(prism, numbered(SubShapeKind::Edge, 3)));
  QVERIFY(!results.at("hold")->error);
  QCOMPARE(partIn(*results.at("hold")).at("index").get<int>(), 3);
  const Results none = evaluated(naming(prism, numbered(SubShapeKind::Edge, 300)));
  QVERIFY(none.at("hold")->parts.empty());  // no signature to keep; telling of it is the feature's own matter
}

void PartReferenceTest::damagedSignaturesLoseThePart() {
  const Prism prism;
  Value part = partIn(*evaluated(naming(prism, numbered(SubShapeKind::Edge, 3))).at("hold"));
  for (const Value& rubbish : {Value{{"faces", 7}}, Value{{"faces", Value::array({1})}, {"sources", 3}},
                               Value{{"source", 1}}, Value{{"structure", Value()}, {"likeness", 2}}, Value::object()}) {
    part["signature"] = rubbish;
    const auto result = evaluated(naming(prism, part)).at("hold");
    QVERIFY(result->error.has_value());
    QCOMPARE(result->error->hint(), std::string("Pick the edge again."));
    QVERIFY2(result->error->message().starts_with("Edge lost: "), result->error->message().c_str());
  }
}

void PartReferenceTest::parametersKeepSignatures() {
  const ParameterSpec edge = subShape("edge");
  const Value part{{"input", "shape"}, {"kind", "edge"}, {"index", 3}, {"signature", {{"structure", "1"}}}};
  QCOMPARE(checked(edge, part), part);
  Value other = part;
  other["signature"] = 5;
  QVERIFY(!checked(edge, other).contains("signature"));
}

BLOSSOM_TEST(PartReferenceTest)
#include "part_reference_test.moc"
