// sweep.h5, read back with HDF5's own library.
#include <gtest/gtest.h>
#include <hdf5.h>
#include <hdf5_hl.h>

#include <cstdlib>
#include <numeric>

#include "lrcs/sweep_csv.h"
#include "tests/cli/made_scene.h"
#include "tests/cli/program.h"

namespace lrcs {
namespace {

class SweepFile : public testing::Test {
 protected:
  SweepFile() { folder_.write("box.stl", two_boxes()); }
  ~SweepFile() override {
    if (file_ >= 0) H5Fclose(file_);
  }
  void sweep(const std::string& more, const Words& flags = {}) {
    std::string text = good_scene.substr(0, good_scene.find("sweep:")) + more;
    folder_.write("scene.yaml", text);
    const Outcome run = run_lrcs(with({"sweep", "scene.yaml", "-o", "out", "--hdf5"}, flags), {folder_.path()});
    ASSERT_EQ(run.status, 0) << run.err;
    file_ = H5Fopen((folder_.path() / "out" / "sweep.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    ASSERT_GE(file_, 0);
  }
  [[nodiscard]] std::vector<hsize_t> shape(const std::string& name) const {
    int rank = 0;
    EXPECT_GE(H5LTget_dataset_ndims(file_, name.c_str(), &rank), 0) << name;
    std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
    EXPECT_GE(H5LTget_dataset_info(file_, name.c_str(), sizes.data(), nullptr, nullptr), 0);
    return sizes;
  }
  [[nodiscard]] std::vector<double> values(const std::string& name) const {
    const auto sizes = shape(name);
    std::vector<double> values(std::accumulate(sizes.begin(), sizes.end(), hsize_t{1}, std::multiplies<>()));
    EXPECT_GE(H5LTread_dataset_double(file_, name.c_str(), values.data()), 0);
    return values;
  }
  [[nodiscard]] std::string words(const std::string& object, const char* attribute) const {
    std::string text(200, '\0');
    EXPECT_GE(H5LTget_attribute_string(file_, object.c_str(), attribute, text.data()), 0) << object;
    return text.c_str();
  }
  // The dimension scale along one of a dataset's dimensions.
  [[nodiscard]] std::string scale(const std::string& name, unsigned dimension) const {
    const hid_t data = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    std::string found;
    const auto take = [](hid_t, unsigned, hid_t attached, void* result) -> herr_t {
      std::string its_name(100, '\0');
      H5DSget_scale_name(attached, its_name.data(), its_name.size());
      *static_cast<std::string*>(result) = its_name.c_str();
      return 1;
    };
    H5DSiterate_scales(data, dimension, nullptr, take, &found);
    H5Dclose(data);
    return found;
  }

  ScratchFolder folder_;
  hid_t file_ = H5I_INVALID_HID;
};

TEST_F(SweepFile, HoldsAGridOfAnglesWithScalesAndUnits) {
  sweep("sweep: {azimuth: [0, 10, 25], elevation: [-5, 20]}\n");
  EXPECT_EQ(shape("sigma"), (std::vector<hsize_t>{2, 3}));
  EXPECT_EQ(scale("sigma", 0), "elevation");
  EXPECT_EQ(scale("sigma", 1), "azimuth");
  EXPECT_EQ(values("azimuth"), (std::vector<double>{0, 10, 25}));
  EXPECT_EQ(values("elevation"), (std::vector<double>{-5, 20}));
  EXPECT_EQ(words("azimuth", "units"), "degree");
  for (const char* name : {"sigma", "bound", "seen_area"}) EXPECT_EQ(words(name, "units"), "m2") << name;
  const auto rows = read_sweep_csv(folder_.path() / "out" / "sweep.csv");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(values("sigma")[k], rows[k].sigma.value);
    EXPECT_EQ(values("bound")[k], rows[k].sigma.bound);
    EXPECT_EQ(values("seen_area")[k], rows[k].seen_area);
  }
}

TEST_F(SweepFile, HoldsLooseDirectionsRowByRowAndTheirFacets) {
  sweep(
      "sweep: {directions: [[0, 1], [40, 2], [7, 3]]}\nreceiver: {bistatic_angle: 10}\n"
      "output: {facets: [{azimuth: 7, elevation: 3}, {azimuth: 0, elevation: 1}]}\n");
  EXPECT_EQ(scale("sigma", 0), "row");
  EXPECT_EQ(values("transmitter_azimuth"), (std::vector<double>{0, 40, 7}));
  const auto rows = read_sweep_csv(folder_.path() / "out" / "sweep.csv");
  EXPECT_EQ(values("receiver_azimuth")[1], rows[1].aspect.receiver.azimuth_deg);
  EXPECT_EQ(values("facet_row"), (std::vector<double>{0, 2}));
  EXPECT_EQ(shape("facet_sigma"), (std::vector<hsize_t>{2, 24}));
  EXPECT_EQ(scale("facet_sigma", 0), "facet_row");
  EXPECT_EQ(scale("facet_sigma", 1), "facet");
  EXPECT_EQ(words("facet_sigma", "units"), "m2");
  const auto sigma = values("facet_sigma");
  for (const std::size_t k : {0U, 1U}) {
    const double sum = std::accumulate(sigma.begin() + 24 * static_cast<long>(k),
                                       sigma.begin() + 24 * (static_cast<long>(k) + 1), 0.0);
    EXPECT_NEAR(sum, rows[2 * k].sigma.value, 1e-12 * rows[2 * k].sigma.value);
  }
  EXPECT_EQ(folder_.read("out/facets.pvd"),
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n"
            "    <DataSet timestep=\"0\" part=\"0\" file=\"facets-1.vtp\"/>\n"
            "    <DataSet timestep=\"2\" part=\"0\" file=\"facets-0.vtp\"/>\n  </Collection>\n</VTKFile>\n");
}

TEST_F(SweepFile, XarrayOpensAsALabelledDataset) {
  // Installed by scripts/install-deps.sh --checks.
  if (std::system("/usr/bin/python3 -c 'import xarray, h5netcdf' 2>/dev/null") != 0)
    GTEST_SKIP() << "no xarray, h5netcdf";
  sweep("sweep: {azimuth: [0, 10, 25], elevation: [-5, 20]}\noutput: {facets: all}\n");
  const std::string command = "/usr/bin/python3 " LRCS_TESTS "/cli/opened_by_xarray.py ";
  EXPECT_EQ(std::system((command + (folder_.path() / "out").string()).c_str()), 0);
}

TEST_F(SweepFile, IsTheSameBytesForAnyNumberOfThreads) {
  const std::string all = "sweep: {azimuth: {from: 0, to: 40, step: 2}}\noutput: {facets: all}\n";
  sweep(all, {"-t", "1"});
  const std::string one = folder_.read("out/sweep.h5");
  H5Fclose(file_);
  sweep(all, {"-t", "4"});
  EXPECT_TRUE(folder_.read("out/sweep.h5") == one);
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "out"))
    EXPECT_NE(entry.path().filename().string().front(), '.');
}

TEST_F(SweepFile, IsWrittenWholeOrNotAtAll) {
  folder_.write("scene.yaml", scene_with("step: 10", "step: 1") + "output: {facets: all}\n");
  const Words words{"sweep", "scene.yaml", "-o", "out", "--hdf5"};
  const Outcome full = run_lrcs(words, {.folder = folder_.path(), .largest_file = 20000});
  EXPECT_EQ(full.status, 1) << full.err;
  EXPECT_NE(full.err.find("sweep.h5: "), std::string::npos) << full.err;
  EXPECT_EQ(full.err.find("HDF5-DIAG"), std::string::npos) << full.err;
  EXPECT_FALSE(folder_.has("out/sweep.h5"));
  EXPECT_FALSE(folder_.has("out/manifest.json"));
}

TEST_F(SweepFile, OfAnEarlierRunIsTakenAway) {
  sweep("sweep: {azimuth: [0, 10]}\noutput: {facets: all}\n");
  EXPECT_TRUE(folder_.has("out/facets.pvd"));
  folder_.write("scene.yaml", good_scene);
  ASSERT_EQ(run_lrcs({"sweep", "scene.yaml", "-o", "out"}, {folder_.path()}).status, 0);
  EXPECT_FALSE(folder_.has("out/sweep.h5"));
  EXPECT_FALSE(folder_.has("out/facets.pvd"));
}

}  // namespace
}  // namespace lrcs
