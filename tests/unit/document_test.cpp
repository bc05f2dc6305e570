#include "document/document.h"

#include <algorithm>

#include "support/documents.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Feature thing(const FeatureId& id, std::vector<FeatureId> inputs = {}) {
  Feature feature;
  feature.id = id;
  feature.type = "test.thing";
  feature.inputs = std::move(inputs);
  return feature;
}

/// Every input stands before its user, and every id once: what each document promises.
bool sound(const Document& document) {
  std::vector<FeatureId> before;
  for (const auto& feature : document.features()) {
    for (const auto& input : feature->inputs)
      if (std::find(before.begin(), before.end(), input) == before.end()) return false;
    if (std::find(before.begin(), before.end(), feature->id) != before.end()) return false;
    before.push_back(feature->id);
  }
  return true;
}

}  // namespace

class DocumentTest : public QObject {
  Q_OBJECT

 private slots:
  void anEditSharesWhatItDoesNotChange() {
    const Document first = Document().with(thing("a")).with(thing("b", {"a"}));
    Feature changed = first.at("b");
    changed.name = "B";
    const Document second = first.with(changed);
    QCOMPARE(first.at("b").name, std::string());
    QCOMPARE(second.at("b").name, std::string("B"));
    QVERIFY(first.features()[0] == second.features()[0]);
  }

  void missingInputsAndCyclesAreRefused() {
    const Document document = Document().with(thing("a")).with(thing("b", {"a"})).with(thing("c", {"b"}));
    VERIFY_ERROR(document.with(thing("d", {"x"})), ErrorCode::NotFound);
    VERIFY_ERROR(document.with(thing("a", {"c"})), ErrorCode::CycleFound);
    VERIFY_ERROR(document.with(thing("a", {"a"})), ErrorCode::CycleFound);
    VERIFY_ERROR(document.with(thing("")), ErrorCode::InvalidInput);
    VERIFY_ERROR(document.at("aa"), ErrorCode::NotFound);
    VERIFY_ERROR(Document::of({thing("a"), thing("a")}), ErrorCode::InvalidInput);
  }

  void aLaterInputMovesForward() {
    const Document document = Document().with(thing("a")).with(thing("b")).with(thing("c", {"b"})).with(thing("a", {"c"}));
    QVERIFY(sound(document));
    QCOMPARE(order(document), (Ids{"b", "c", "a"}));
  }

  void usedFeaturesStay() {
    const Document document = Document().with(thing("a")).with(thing("b", {"a"}));
    try {
      (void)document.without("a");
      QFAIL("removed");
    } catch (const Error& e) {
      QCOMPARE(e.code(), ErrorCode::InUse);
      QCOMPARE(e.message(), std::string("\"a\" is used by \"b\"."));
    }
    QCOMPARE(order(document.without("b").without("a")), Ids{});
    VERIFY_ERROR(document.without("x"), ErrorCode::NotFound);
  }

  void movingKeepsInputsBeforeUsers() {
    const Document document = Document().with(thing("a")).with(thing("b")).with(thing("c", {"a"}));
    QCOMPARE(order(document.moved("b", 0)), (Ids{"b", "a", "c"}));
    QCOMPARE(order(document.moved("b", 2)), (Ids{"a", "c", "b"}));
    VERIFY_ERROR(document.moved("a", 2), ErrorCode::InvalidInput);
    VERIFY_ERROR(document.moved("c", 0), ErrorCode::InvalidInput);
    VERIFY_ERROR(document.moved("c", 3), ErrorCode::InvalidInput);
    VERIFY_ERROR(document.moved("x", 0), ErrorCode::NotFound);
  }

  void freshIdsAreFree() {
    const Document document = Document().with(thing("sweep-1")).with(thing("sweep-3"));
    QCOMPARE(document.freshId("sweep"), FeatureId("sweep-2"));
    QCOMPARE(document.freshId("morph"), FeatureId("morph-1"));
  }

  void aLongChainInReverseOrderIsSorted() {
    std::vector<Feature> features;
    for (int i = 200000; i > 0; --i)
      features.push_back(thing(std::to_string(i), i > 1 ? Ids{std::to_string(i - 1)} : Ids{}));
    const Document document = Document::of(std::move(features));
    QCOMPARE(document.features().front()->id, FeatureId("1"));
    QCOMPARE(document.features().back()->id, FeatureId("200000"));
  }

  void randomEditsKeepDocumentsSound() {
    auto random = test::seededRandom();
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    Document document;
    int refused = 0;
    for (int step = 0; step < 4000; ++step) {
      const Document before = document;
      const Ids ids = order(document);
      const auto any = [&] { return ids.empty() ? FeatureId("none") : ids[below(ids.size())]; };
      try {
        switch (below(4)) {
          case 0:
            document = document.with(thing(document.freshId("f"), ids.empty() ? Ids{} : Ids{any(), any()}));
            break;
          case 1:
            document = document.with(thing(any(), {any()}));
            break;
          case 2:
            document = document.moved(any(), below(ids.size() + 1));
            break;
          default:
            document = document.without(any());
        }
      } catch (const Error& e) {
        QVERIFY(e.code() != ErrorCode::Internal);
        QCOMPARE(order(document), order(before));
        ++refused;
      }
      QVERIFY(sound(document));
    }
    QVERIFY2(refused > 0 && refused < 4000, "both outcomes are tried");
  }
};

BLOSSOM_TEST(DocumentTest)
#include "document_test.moc"
