#include "oracle/sweep_checker.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

#include "core/file.h"
#include "support/support.h"

/// The real binary makes the files; OCCT alone and the printed formula judge them.
class SweepStepTest : public QObject {
  Q_OBJECT

  blossom::TemporaryFolder folder_;

  QString path(const char* name) const { return QString::fromStdString((folder_.path() / name).string()); }
  static QString motion(const char* name) { return QString::fromStdString(blossom::test::sample(name).string()); }

  /// Runs `blossom sweep ARGUMENTS --json`. @returns what it printed.
  static QJsonObject sweep(const QStringList& arguments) {
    QProcess process;
    process.start(QString::fromStdString((blossom::test::buildFolder() / "bin/blossom").string()),
                  QStringList{"sweep"} + arguments + QStringList{"--json"});
    if (!process.waitForFinished(120000) || process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
      qWarning("%s%s", process.readAllStandardOutput().constData(), process.readAllStandardError().constData());
    return QJsonDocument::fromJson(process.readAllStandardOutput()).object();
  }

  static double error(const QString& motionFile, const Geom_BSplineSurface& surface) {
    auto random = blossom::test::seededRandom();
    return sweep_checker::largestError(sweep_checker::MotionFile(motionFile.toStdString()), surface, 10000, random);
  }

 private slots:
  void exactSurfaceEqualsThePrintedFormula_data() {
    QTest::addColumn<QString>("sample");
    QTest::addColumn<QString>("output");
    QTest::addColumn<double>("bound");
    for (const char* sample : {"propeller", "cylinder", "torus", "helicoid", "twisted-tube"}) {
      QTest::newRow(qPrintable(QString("%1 STEP").arg(sample)))
          << QString("%1.json").arg(sample) << QString("%1.step").arg(sample) << 1e-9;
      QTest::newRow(qPrintable(QString("%1 IGES").arg(sample)))
          << QString("%1.json").arg(sample) << QString("%1.igs").arg(sample) << 1e-8;
    }
  }
  void exactSurfaceEqualsThePrintedFormula() {
    QFETCH(QString, sample);
    QFETCH(QString, output);
    QFETCH(double, bound);
    const QString file = path(qPrintable(output)), input = motion(qPrintable(sample));
    const QJsonObject printed = sweep({input, "-o", file});
    QVERIFY2(QFile::exists(file), qPrintable(file));
    const auto surface = sweep_checker::readSurface(file.toStdString());
    const sweep_checker::MotionFile direct(input.toStdString());
    QCOMPARE(surface->UDegree(), direct.degreeU());
    QCOMPARE(surface->VDegree(), direct.degreeV());
    QCOMPARE(printed["result"].toObject()["degree_u"].toInt(), direct.degreeU());
    QVERIFY(surface->IsURational() || surface->IsVRational());
    if (sample == "propeller.json")
      QCOMPARE(QString("%1x%2").arg(surface->UDegree()).arg(surface->VDegree()), QString("9x12"));
    const double found = error(input, *surface);
    qInfo("figure %s_error %.3g", qPrintable(output), found);
    QVERIFY2(found <= bound, qPrintable(QString::number(found)));
  }

  void cubicSurfaceKeepsItsWord() {
    const QString file = path("cubic.step"), input = motion("propeller.json");
    const QJsonObject printed = sweep({input, "--mode", "cubic", "--tolerance", "1e-3", "-o", file});
    QVERIFY(QFile::exists(file));
    const double claimed = printed["stats"].toObject()["deviation"].toDouble(1e9);
    QVERIFY(claimed <= 1e-3);
    const auto surface = sweep_checker::readSurface(file.toStdString());
    QCOMPARE(surface->UDegree(), 3);
    QCOMPARE(surface->VDegree(), 3);
    const double found = error(input, *surface);
    QVERIFY2(found <= claimed * 1.02 && found <= 1e-3, qPrintable(QString("%1, claimed %2").arg(found).arg(claimed)));
  }

  void solidHoldsTheVolumeOfItsMesh() {
    const double deflection = 0.05;
    const QString step = path("solid.step"), stl = path("solid.stl"), input = motion("propeller.json");
    const QJsonObject solid = sweep({input, "--solid", "-o", step});
    sweep({input, "--solid", "-o", stl, "--chord", QString::number(deflection)});
    QVERIFY(QFile::exists(step) && QFile::exists(stl));
    STEPControl_Reader reader;
    QCOMPARE(reader.ReadFile(step.toStdString().c_str()), IFSelect_RetDone);
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    QVERIFY(TopExp_Explorer(shape, TopAbs_SOLID).More());
    QVERIFY(BRepCheck_Analyzer(shape).IsValid());
    GProp_GProps area, volume;
    BRepGProp::SurfaceProperties(shape, area, 1e-6);
    BRepGProp::VolumePropertiesGK(shape, volume, 1e-6, true);
    QVERIFY(volume.Mass() > 0);
    QVERIFY(solid["result"].toObject()["closed"].toBool());
    COMPARE_NEAR(solid["result"].toObject()["volume"].toDouble(), volume.Mass(), 1e-5 * volume.Mass());
    COMPARE_NEAR(stlVolume(stl), volume.Mass(), area.Mass() * deflection);
  }

 private:
  /// Enclosed volume of a binary STL file by the divergence theorem.
  static double stlVolume(const QString& file) {
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly)) return 0;
    const QByteArray bytes = in.readAll();
    double six = 0;
    for (qsizetype at = 84; at + 50 <= bytes.size(); at += 50) {
      float c[9];
      std::memcpy(c, bytes.constData() + at + 12, sizeof c);
      six += double(c[0]) * (double(c[4]) * c[8] - double(c[5]) * c[7]) +
             double(c[1]) * (double(c[5]) * c[6] - double(c[3]) * c[8]) +
             double(c[2]) * (double(c[3]) * c[7] - double(c[4]) * c[6]);
    }
    return six / 6;
  }
};

BLOSSOM_TEST(SweepStepTest)
#include "sweep_step_test.moc"
