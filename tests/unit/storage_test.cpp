#include "document/storage.h"

#include <QCryptographicHash>
#include <algorithm>
#include <fstream>

#include "core/file.h"
#include "core/version.h"
#include "core/zip_archive.h"
#include "document/json_text.h"
#include "support/errors.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Feature sweepFeature(const FeatureId& id, std::vector<FeatureId> inputs = {}) {
  Feature feature;
  feature.id = id;
  feature.type = "sweep.sweep";
  feature.name = "Feature " + id;
  feature.inputs = std::move(inputs);
  return feature;
}

std::string assetText() { return "solid cube\n  a text that stands for a mesh\nendsolid\n"; }

/// Everything that a document can hold.
Document rich() {
  Feature import = sweepFeature("import-1");
  import.type = "exchange.import";
  import.parameters = {{ "file", { {"path", "cube.stl"}, { "asset", contentHash(assetText()) } } }};
  Feature sweep = sweepFeature("sweep-1", {"import-1"});
  sweep.parameters = {
      {"t", 0.1}, {"mode", "cubic"}, {"pole", {1.0 / 3, 2e-17, -1e300}}, {"text", "Bl\u00fcte \"quoted\", [x]: {y}\n"}};
  sweep.visible = false;
  sweep.suppressed = true;
  sweep.extra = {{"colour", "#ff8800"}};
  return Document()
      .with(import)
      .with(sweep)
      .withAsset(contentHash(assetText()), std::make_shared<const std::string>(assetText()))
      .withExtra({{"camera", {{"eye", {1, 2, 3}}}}});
}

void verifySame(const Document& a, const Document& b) {
  QCOMPARE(a.features().size(), b.features().size());
  for (std::size_t i = 0; i < a.features().size(); ++i)
    QVERIFY2(*a.features()[i] == *b.features()[i], a.features()[i]->id.c_str());
  QCOMPARE(a.extra(), b.extra());
  QCOMPARE(a.assets().size(), b.assets().size());
  for (const auto& [hash, content] : a.assets()) QCOMPARE(*b.assets().at(hash), *content);
}

std::string bytesOf(const Document& document) {
  const TemporaryFolder folder;
  saveDocument(document, folder.path() / "a.blossom");
  return readFile(folder.path() / "a.blossom");
}

OpenedDocument open(const std::string& bytes, bool salvage = false) {
  static const TemporaryFolder folder;  // one for thousands of files, without syncing any to the disk
  static int count = 0;
  const auto place = folder.path() / std::to_string(++count);
  std::filesystem::create_directory(place);
  std::ofstream(place / "a.blossom", std::ios::binary) << bytes;
  return openDocument(place / "a.blossom", salvage);
}

std::string zipOf(const std::vector<ZipEntry>& entries) {
  const TemporaryFolder folder;
  writeZip(folder.path() / "a.zip", entries, Progress::none());
  return readFile(folder.path() / "a.zip");
}

/// JSON written with apostrophes.
std::string json(std::string text) {
  std::replace(text.begin(), text.end(), '\'', '"');
  return text;
}

}  // namespace

class StorageTest : public QObject {
  Q_OBJECT

 private slots:
  void hashesAreThoseOfTheStandard() {
    // FIPS 180-2, appendix B, and the empty text
    QCOMPARE(contentHash(""), std::string("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"));
    QCOMPARE(contentHash("abc"), std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
    QCOMPARE(contentHash("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
             std::string("248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"));
    QCOMPARE(contentHash(std::string(1000000, 'a')),
             std::string("cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"));
  }

  /// Against Qt's own implementation, at every length around the block size.
  void hashesAgreeWithAnotherImplementation() {
    auto random = test::seededRandom();
    for (int size = 0; size < 300; ++size) {
      std::string content;
      for (int i = 0; i < size; ++i) content += static_cast<char>(random());
      const QByteArray expected =
          QCryptographicHash::hash(QByteArray::fromStdString(content), QCryptographicHash::Sha256).toHex();
      QCOMPARE(contentHash(content), expected.toStdString());
    }
  }

  void whatIsSavedIsOpened() {
    const OpenedDocument opened = open(bytesOf(rich()));
    verifySame(opened.document, rich());
    QVERIFY(opened.warnings.empty());
    verifySame(fromJson(toJson(rich()))
                   .document.withAsset(contentHash(assetText()), std::make_shared<const std::string>(assetText())),
               rich());
  }

  void theTextIsReadableAndStable() {
    const std::string text = toJson(rich());
    QCOMPARE(toJson(fromJson(text).document), text);
    QVERIFY(text.starts_with("{\n  \"blossom\": 1,\n  \"features\": [\n"));
    QVERIFY2(text.find("\"pole\": [0.3333333333333333, 2e-17, -1e+300]") != std::string::npos, text.c_str());
    QCOMPARE(bytesOf(rich()), bytesOf(rich()));
  }

  void theZipIsAnOrdinaryOne() {
    const ZipContent content = readZip(bytesOf(rich()), [](std::string_view) { return true; });
    QCOMPARE(content.entries.at("mimetype"), std::string("application/x-blossom"));
    QCOMPARE(content.entries.at("document.json"), toJson(rich()));
    QCOMPARE(content.entries.at("assets/" + contentHash(assetText())), assetText());
    QVERIFY2(bytesOf(rich()).substr(30, 29) == "mimetypeapplication/x-blossom", "the type stands in front, uncompressed");
  }

  void assetsNobodyNamesAreNotSaved() {
    const Document document = rich().withAsset(contentHash("unused"), std::make_shared<const std::string>("unused"));
    QCOMPARE(open(bytesOf(document)).document.assets().size(), std::size_t{1});
  }

  void unknownKeysArePreserved() {
    const std::string text =
        json("{'blossom': 1, 'later': [1], 'features': [{'id': 'a', 'type': 'x.y', 'glow': {'b': 2}}]}");
    const Document document = fromJson(toJson(fromJson(text).document)).document;
    QCOMPARE(document.extra(), (Value{{"later", {1}}}));
    QCOMPARE(document.at("a").extra, (Value{{"glow", {{"b", 2}}}}));
  }

  void aFailedSaveLeavesTheOldFile() {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.blossom";
    saveDocument(rich(), path);
    const std::string before = readFile(path);
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(saveDocument(Document(), path, Progress(token)), ErrorCode::Cancelled);
    QCOMPARE(readFile(path), before);
    VERIFY_ERROR(saveDocument(rich(), folder.path() / "no/such/folder.blossom"), ErrorCode::FileUnwritable);
    QCOMPARE(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  }

  /// Every format that was ever written opens. BLOSSOM_WRITE_FIXTURES=1 writes the file of this version, once.
  void earlierVersionsOpen() {
    const auto folder = test::sourceFolder() / "tests/fixtures/documents";
    const auto current = folder / ("v" + std::to_string(documentFormatVersion) + ".blossom");
    if (std::getenv("BLOSSOM_WRITE_FIXTURES")) saveDocument(rich(), current);
    QVERIFY(std::filesystem::exists(current));
    const OpenedDocument opened = openDocument(folder / "v1.blossom");
    QVERIFY(opened.warnings.empty());
    verifySame(opened.document, rich());
  }

  void aLaterFormatIsTold() {
    const Error error = errorOf([] { fromJson(json("{'blossom': 7, 'features': []}")); });
    QCOMPARE(error.code(), ErrorCode::FormatTooNew);
    QCOMPARE(error.message(),
             std::string("The document was written by a later Blossom (format 7; this one reads up to 1)."));
    VERIFY_ERROR(fromJson(json("{'blossom': 7, 'features': [{"), true), ErrorCode::FormatTooNew);
    VERIFY_ERROR(fromJson(json("{'blossom': 18446744073709551615, 'features': []}"), true), ErrorCode::FormatTooNew);
  }

  void damagedTextIsRefusedOrRecovered_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("recovered");
    QTest::addColumn<QString>("warning");
    const std::string head = json("{'blossom': 1, 'features': [{'id': 'a', 'type': 'x.y'}, ");
    const auto row = [&](const char* name, const std::string& rest, int recovered, const std::string& warning) {
      QTest::newRow(name) << QString::fromStdString(head + rest) << recovered << QString::fromStdString(warning);
    };
    row("missing input", json("{'id': 'b', 'type': 'x.y', 'inputs': ['z', 'a']}]}"), 2,
        json("The input 'z' of 'b' is missing."));
    row("double id", json("{'id': 'a', 'type': 'x.y'}]}"), 2, json("Two features have the id 'a'."));
    row("cycle", json("{'id': 'b', 'type': 'x.y', 'inputs': ['c']}, {'id': 'c', 'type': 'x.y', 'inputs': ['b']}]}"), 3,
        json("'b' depends on itself."));
    row("self", json("{'id': 'b', 'type': 'x.y', 'inputs': ['b']}]}"), 2, json("'b' depends on itself."));
    row("no id", json("{'type': 'x.y'}]}"), 1, "Feature 2 has no id.");
    row("no type", json("{'id': 'b'}]}"), 1, "Feature 2 has no type.");
    row("no object", json("17]}"), 1, "Feature 2 is no object.");
    row("wrong parameters", json("{'id': 'b', 'type': 'x.y', 'parameters': []}]}"), 2,
        json("'parameters' of feature 2 must be an object."));
    row("wrong inputs", json("{'id': 'b', 'type': 'x.y', 'inputs': [1]}]}"), 2,
        json("'inputs' of feature 2 must be a list of ids."));
    row("wrong flag", json("{'id': 'b', 'type': 'x.y', 'visible': 1}]}"), 2,
        json("'visible' of feature 2 must be true or false."));
    row("cut off", json("{'id': 'b', 'type': 'x.y', 'name': '}'}, {'id': 'c', 'ty"), 2, "The JSON cannot be read");
    row("rubbish", json("{'id': 'b', 'type': 'x.y'} oops {'id': 'c', 'type': 'x.y'}]}"), 3, "The JSON cannot be read");
  }

  void damagedTextIsRefusedOrRecovered() {
    QFETCH(QString, text);
    QFETCH(int, recovered);
    QFETCH(QString, warning);
    const Error error = errorOf([&] { fromJson(text.toStdString()); });
    QCOMPARE(error.code(), ErrorCode::FormatDamaged);
    QVERIFY(error.message().starts_with("The document is damaged: "));
    QCOMPARE(error.hint(), std::string("What is readable of it can be recovered and opened."));
    const OpenedDocument opened = fromJson(text.toStdString(), true);
    QCOMPARE(static_cast<int>(opened.document.features().size()), recovered);
    QVERIFY2(!opened.warnings.empty() && QString::fromStdString(opened.warnings.front()).startsWith(warning),
             opened.warnings.front().c_str());
  }

  void hopelessTextIsAnErrorInAnyCase() {
    for (const char* text : {"", "[]", "{}", "17", "{\"blossom\": 1}", "{\"blossom\": 1, \"features\": {}}",
                             "{\"blossom\": 0, \"features\": 3}"})
      for (const bool salvage : {false, true}) VERIFY_ERROR(fromJson(text, salvage), ErrorCode::FormatDamaged);
  }

  /// Cut at every place: an error, or with salvage a part of the document, and all of it once its text is whole.
  void aFileCutAnywhereIsRecoveredAsFarAsItGoes() {
    const std::string bytes = bytesOf(rich());
    std::size_t most = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      const std::string cut = bytes.substr(0, size);
      QCOMPARE(errorOf([&] { open(cut); }).code(), ErrorCode::FormatDamaged);
      try {
        const OpenedDocument opened = open(cut, true);
        QVERIFY(!opened.warnings.empty());
        QVERIFY2(opened.document.features().size() >= most, "more bytes never recover less");
        most = opened.document.features().size();
        if (!opened.document.assets().empty()) verifySame(opened.document, rich());
      } catch (const Error& e) {
        QCOMPARE(e.code(), ErrorCode::FormatDamaged);
        QCOMPARE(most, std::size_t{0});
      }
    }
    QCOMPARE(most, std::size_t{2});
  }

  void mutatedFilesNeverCrash() {
    auto random = test::seededRandom();
    const std::string bytes = bytesOf(rich());
    for (int i = 0; i < 1500; ++i) {
      std::string mutated = bytes;
      for (std::size_t n = 1 + random() % 4; n > 0; --n) mutated[random() % mutated.size()] = static_cast<char>(random());
      if (random() % 4 == 0) mutated.erase(random() % mutated.size(), random() % 40);
      for (const bool salvage : {false, true}) {
        try {
          const OpenedDocument opened = open(mutated, salvage);
          for (const auto& feature : opened.document.features()) QVERIFY(!feature->id.empty());
        } catch (const Error& e) {
          QVERIFY2(e.code() == ErrorCode::FormatDamaged || e.code() == ErrorCode::FormatTooNew ||
                       e.code() == ErrorCode::LimitExceeded,
                   e.what());
        }
      }
    }
  }

  void missingOrForgedContentIsNoticed() {
    const std::string text = toJson(rich());
    const std::string without = zipOf({{"document.json", text}});
    QCOMPARE(errorOf([&] { open(without); }).message(),
             std::string("The document a.blossom is damaged: the imported file of \"Feature import-1\" is missing."));
    QCOMPARE(open(without, true).warnings,
             std::vector<std::string>{"The imported file of \"Feature import-1\" is missing."});
    const std::string forged = zipOf({{"document.json", text}, {"assets/" + contentHash(assetText()), "something else"}});
    VERIFY_ERROR(open(forged), ErrorCode::FormatDamaged);
    QCOMPARE(open(forged, true).warnings.size(), std::size_t{2});
    VERIFY_ERROR(open(zipOf({{"readme", "no document"}})), ErrorCode::FormatDamaged);
  }

  void whatIsNoDocumentIsTold() {
    QCOMPARE(errorOf([] { open("solid cube"); }).message(), std::string("a.blossom is not a Blossom document."));
    VERIFY_ERROR(open(""), ErrorCode::FormatDamaged);
    VERIFY_ERROR(openDocument("/no/such/file.blossom"), ErrorCode::FileNotFound);
    VERIFY_ERROR(openDocument("/tmp"), ErrorCode::FileUnreadable);
  }

  void bombsAreNotUnpacked() {
    const std::string large(10 << 20, 'x');
    const std::string bomb = zipOf({{"a", large}, {"b", large}});
    QVERIFY(bomb.size() < large.size() / 100);
    const auto all = [](std::string_view) { return true; };
    for (const ZipLimits& limits : {ZipLimits{1 << 20, 1 << 30}, ZipLimits{1 << 30, 15 << 20}}) {
      VERIFY_ERROR(readZip(bomb, all, limits), ErrorCode::LimitExceeded);
      VERIFY_ERROR(salvageZip(bomb, all, limits), ErrorCode::LimitExceeded);
    }
  }

  void aTooLongDocumentIsRefusedQuickly() {
    std::string text = json("{'blossom': 1, 'features': [");
    for (int i = 0; i < 20000; ++i) text += json("{'id': 'f") + std::to_string(i) + json("', 'type': 'x.y'},");
    text.back() = ']';
    VERIFY_ERROR(fromJson(text + "}"), ErrorCode::LimitExceeded);
  }
};

BLOSSOM_TEST(StorageTest)
#include "storage_test.moc"
