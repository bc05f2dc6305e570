#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <TopExp_Explorer.hxx>
#include <fstream>

#include "core/version.h"
#include "exchange/cad/brep_export.h"
#include "exchange/cad/brep_import.h"
#include "exchange/cad/iges_colors.h"
#include "exchange/cad/iges_names.h"
#include "exchange/cad/occt_io.h"
#include "exchange/cad/xcaf_read.h"
#include "exchange/cad/xcaf_write.h"
#include "exchange/format/axis_curves.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

/// The last line of a fixed-format file has a T in column 73 (IGES 5.3, 2.2.4.6).
void requireLastLine(const std::string& path) {
  const std::string tail = tailOf(path, 4096);
  for (std::size_t at = tail.find('T'); at != std::string::npos; at = tail.find('T', at + 1)) {
    const std::size_t start = tail.find_last_of("\r\n", at) + 1;  // npos + 1 is the start of the text
    if (at - start == 72) return;
  }
  throw Error(ErrorCode::FormatDamaged, "Its last line (T) is missing: it was cut off or not written completely.",
              "Fetch or export the file again.");
}

/// As IGESControl_Writer::Write, but with all digits.
bool print(IGESControl_Writer& writer, const std::string& path) {
  writer.ComputeModel();
  IGESData_IGESWriter text(writer.Model());
  text.FloatWriter().SetFormat(exactNumber);
  text.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
  std::ofstream stream(path, std::ios::binary);
  const bool printed = text.Print(stream);
  stream.close();
  return printed && stream.good();
}

/// Only B-Rep entities can represent a solid; loose faces are written as trimmed surfaces, which every program reads.
bool containsSolid(const Brep& brep) { return TopExp_Explorer(brep.shape(), TopAbs_SOLID).More(); }

}  // namespace

void writeIges(const Brep& brep, const std::string& path, const Value& options, const Progress& progress) {
  const OcctSession session;
  const OcctSetting unit("write.iges.unit", "MM");
  const OcctSetting mode("write.iges.brep.mode", options.value("brep", true) && containsSolid(brep) ? 1 : 0);
  const OcctSetting product("write.iges.header.product", "Blossom");
  const OcctSetting author("write.iges.header.author", "Blossom");
  const OcctSetting company("write.iges.header.company", "");
  const OcctSetting receiver("write.iges.header.receiver", "");
  withOcctErrors(ErrorCode::FileUnwritable, "The shape cannot be written as IGES.", [&] {
    const Handle(TDocStd_Document) document = toDocument(brep);
    IGESCAFControl_Writer writer;
    writer.SetNameMode(Standard_False);
    Handle(OcctProgress) watcher = new OcctProgress(progress, "Writing");
    const bool transferred = writer.Transfer(document, watcher->Start());
    progress.check();
    if (!transferred) throw Error(ErrorCode::InvalidInput, "The shape holds something that IGES cannot hold.");
    writeIgesNames(writer, document);
    if (!print(writer, path))
      throw Error(ErrorCode::FileUnwritable, "The file \"" + path + "\" cannot be written.",
                  "Check the folder and the space left.");
  });
}

BrepImport readIges(const std::string& path, const Progress& progress) {
  requireLastLine(path);
  const OcctSession session;
  const OcctSetting unit("xstep.cascade.unit", "MM");
  return withOcctErrors(ErrorCode::FormatDamaged, "It cannot be understood as IGES.", [&] {
    progress.report(0, "Reading");
    IGESCAFControl_Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
      throw Error(ErrorCode::FormatDamaged, "It breaks the rules of IGES so badly that nothing can be read.");
    Handle(TDocStd_Document) document = newDocument();
    Handle(OcctProgress) watcher = new OcctProgress(progress.part(0.2, 1), "Building shapes");
    reader.Transfer(document, watcher->Start());
    addLostFaceColors(reader, document);
    return BrepImport{fromDocument(document), Value::object(), {}};
  });
}

Format igesFormat() {
  ParameterSpec brep = flag();
  brep.name = "brep";
  brep.help = "Write solids as solids (entity 186); off: as loose trimmed surfaces, for programs that read nothing else.";
  brep.fallback = true;
  Format format;
  format.id = "iges";
  format.title = "IGES 5.3";
  format.extensions = {"iges", "igs"};
  format.writeOptions.push_back(brep);
  format.read = [](const fs::path& path, const Value&, const Progress& progress) {
    return importBrep("iges.read", path, progress);
  };
  format.writeOptions.push_back(heightsOption(true));
  format.write = [](const Shape& shape, const fs::path& path, const Value& options, const Progress& progress) {
    exportBrep("iges.write", toBrep(shape, options), path, options, progress);
  };
  format.writes = brepKinds();
  return format;
}

}  // namespace blossom
