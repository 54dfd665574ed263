#include "cli/sweep_hdf5.h"

#include <fmt/format.h>
#include <hdf5.h>
#include <hdf5_hl.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/version.h"
#include "base/whole_file.h"
#include "lrcs/aspect_grid.h"

namespace lrcs {
namespace {

constexpr double most_facet_bytes = 4e9;

struct Dimension {
  std::string name;
  hsize_t size;
};

// Directions that repeat are no coordinates.
std::size_t azimuths_of(const std::vector<AspectAngles>& directions) {
  std::set<std::pair<double, double>> different;
  for (const auto& [azimuth, elevation] : directions) different.emplace(azimuth, elevation);
  return different.size() == directions.size() ? azimuths_of_grid(directions) : 0;
}

template <class T, class Of>
std::vector<T> collected(std::size_t size, const Of& of) {
  std::vector<T> values;
  for (std::size_t k = 0; k < size; ++k) values.push_back(of(k));
  return values;
}

// HDF5's own complaints go nowhere, thread by thread; what failed is said by whoever called.
void keep_quiet() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace

struct SweepHdf5::Hidden {
  std::filesystem::path file;
  const Scene& scene;
  const LoadedTarget& loaded;
  std::vector<std::size_t> facet_rows;
  hid_t id = H5I_INVALID_HID;
  hid_t facet_sigma = H5I_INVALID_HID, seen_fraction = H5I_INVALID_HID;

  [[noreturn]] void fail() const { throw std::runtime_error(file.string() + ": cannot be written as HDF5"); }
  template <class Status>
  Status good(Status status) const {
    if (status < 0) fail();
    return status;
  }

  void say(hid_t object, const char* name, const std::string& text) const {
    good(H5LTset_attribute_string(id, name_of(object).c_str(), name, text.c_str()));
  }
  [[nodiscard]] std::string name_of(hid_t object) const {
    std::string name(static_cast<std::size_t>(good(H5Iget_name(object, nullptr, 0))), '\0');
    H5Iget_name(object, name.data(), name.size() + 1);
    return name;
  }

  hid_t made(const std::string& name, hid_t type, const std::vector<Dimension>& along, const std::string& unit,
             const std::string& meaning) const {
    const auto sizes = collected<hsize_t>(along.size(), [&](std::size_t k) { return along[k].size; });
    const hid_t space = good(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr));
    const hid_t timeless = good(H5Pcreate(H5P_DATASET_CREATE));
    good(H5Pset_obj_track_times(timeless, false));
    const hid_t data = good(H5Dcreate2(id, name.c_str(), type, space, H5P_DEFAULT, timeless, H5P_DEFAULT));
    H5Pclose(timeless);
    H5Sclose(space);
    if (!unit.empty()) say(data, "units", unit);
    say(data, "long_name", meaning);
    const bool is_scale = along.size() == 1 && along[0].name == name;
    if (is_scale) good(H5DSset_scale(data, name.c_str()));
    for (std::size_t k = 0; k < along.size() && !is_scale; ++k) {
      const hid_t scale = good(H5Dopen2(id, along[k].name.c_str(), H5P_DEFAULT));
      good(H5DSattach_scale(data, scale, static_cast<unsigned>(k)));
      H5Dclose(scale);
    }
    return data;
  }

  void put(const std::string& name, const std::vector<Dimension>& along, const std::string& unit,
           const std::string& meaning, const std::vector<double>& values) const {
    const hid_t data = made(name, H5T_IEEE_F64LE, along, unit, meaning);
    good(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    H5Dclose(data);
  }
  void put_numbers(const std::string& name, const std::vector<Dimension>& along, const std::string& meaning,
                   const std::vector<std::uint64_t>& values) const {
    const hid_t data = made(name, H5T_STD_I64LE, along, "", meaning);
    good(H5Dwrite(data, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    H5Dclose(data);
  }
  void put_words(const std::string& name, const std::vector<Dimension>& along, const std::string& meaning,
                 const std::vector<std::string>& values) const {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    const hid_t data = made(name, type, along, "", meaning);
    const auto texts = collected<const char*>(values.size(), [&](std::size_t k) { return values[k].c_str(); });
    good(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()));
    H5Dclose(data);
    H5Tclose(type);
  }
  void put_scale(const Dimension& along, const std::string& meaning) const {
    put_numbers(along.name, {along}, meaning, collected<std::uint64_t>(along.size, [](std::size_t k) { return k; }));
  }

  void make_facets() {
    if (facet_rows.empty()) return;
    const Target& target = loaded.target;
    const Dimension row{"facet_row", facet_rows.size()}, facet{"facet", target.mesh.size()};
    const Dimension part{"part_number", target.mesh.part.names.size()};
    const Dimension material{"material_number", target.materials.size()};
    put_numbers("facet_row", {row}, "row of the sweep", {facet_rows.begin(), facet_rows.end()});
    put_scale(facet, "number of the facet");
    put_scale(part, "number of the part");
    put_scale(material, "number of the material");
    put_numbers("part", {facet}, "part of the facet", {target.mesh.part.of.begin(), target.mesh.part.of.end()});
    put_numbers("material", {facet}, "material of the facet's front", {target.material.begin(), target.material.end()});
    const auto& back = target.back_material();
    put_numbers("material_back", {facet}, "material of the facet's back", {back.begin(), back.end()});
    put_numbers("source_facet", {facet}, "number of the polygon in the target's file",
                {target.mesh.source_facet.begin(), target.mesh.source_facet.end()});
    put("area", {facet}, "m2", "area of the facet", target.mesh.areas);
    put_words("part_name", {part}, "name of the part", target.mesh.part.names);
    put_words("material_name", {material}, "name of the material",
              collected<std::string>(material.size, [&](std::size_t k) { return target.materials[k].name; }));
    facet_sigma = made("facet_sigma", H5T_IEEE_F64LE, {row, facet}, "m2", "the facet's share of sigma");
    seen_fraction = made("seen_fraction", H5T_IEEE_F64LE, {row, facet}, "1", "part of the facet that is lit and seen");
  }

  void put_row(hid_t data, std::size_t place, const std::vector<double>& values) const {
    const std::array<hsize_t, 2> start{place, 0}, count{1, values.size()};
    const hid_t there = good(H5Dget_space(data)), here = good(H5Screate_simple(2, count.data(), nullptr));
    good(H5Sselect_hyperslab(there, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
    good(H5Dwrite(data, H5T_NATIVE_DOUBLE, here, there, H5P_DEFAULT, values.data()));
    H5Sclose(here);
    H5Sclose(there);
  }

  void put_rows(const std::vector<SweepRow>& rows) const {
    const auto of = [&](const auto& value) {
      return collected<double>(rows.size(), [&](std::size_t k) { return value(rows[k]); });
    };
    const auto transmitter_azimuth = of([](const SweepRow& r) { return r.aspect.transmitter.azimuth_deg; });
    const auto transmitter_elevation = of([](const SweepRow& r) { return r.aspect.transmitter.elevation_deg; });
    const std::size_t azimuths = azimuths_of(scene.directions);
    std::vector<Dimension> along{{"row", rows.size()}};
    if (azimuths > 0) {
      along = {{"elevation", rows.size() / azimuths}, {"azimuth", azimuths}};
      put("elevation", {along[0]}, "degree", "elevation of the transmitter from the xy-plane toward +z",
          collected<double>(along[0].size, [&](std::size_t k) { return transmitter_elevation[k * azimuths]; }));
      put("azimuth", {along[1]}, "degree", "azimuth of the transmitter from +x toward +y",
          collected<double>(azimuths, [&](std::size_t k) { return transmitter_azimuth[k]; }));
    } else {
      put_scale(along[0], "row of the sweep");
      put("transmitter_azimuth", along, "degree", "from +x toward +y", transmitter_azimuth);
      put("transmitter_elevation", along, "degree", "from the xy-plane toward +z", transmitter_elevation);
    }
    put("receiver_azimuth", along, "degree", "from +x toward +y",
        of([](const SweepRow& r) { return r.aspect.receiver.azimuth_deg; }));
    put("receiver_elevation", along, "degree", "from the xy-plane toward +z",
        of([](const SweepRow& r) { return r.aspect.receiver.elevation_deg; }));
    put("sigma", along, "m2", "laser radar cross section", of([](const SweepRow& r) { return r.sigma.value; }));
    put("bound", along, "m2", "bound of the error of sigma", of([](const SweepRow& r) { return r.sigma.bound; }));
    put("seen_area", along, "m2", "area lit and seen, projected toward the receiver",
        of([](const SweepRow& r) { return r.seen_area; }));
  }
};

SweepHdf5::SweepHdf5(std::filesystem::path file, const Scene& scene, const LoadedTarget& loaded,
                     std::vector<std::size_t> facet_rows)
    : hidden_(new Hidden{std::move(file), scene, loaded, std::move(facet_rows)}) {
  Hidden& h = *hidden_;
  keep_quiet();
  const double facet_bytes =
      16.0 * static_cast<double>(h.facet_rows.size()) * static_cast<double>(loaded.target.mesh.size());
  if (facet_bytes > most_facet_bytes)
    throw InputError(
        fmt::format("--hdf5: the facets of {} rows take {:.1f} GB, expected at most {:.0f} GB; ask for fewer",
                    h.facet_rows.size(), 1e-9 * facet_bytes, 1e-9 * most_facet_bytes));
  // In memory, to be written whole.
  const hid_t timeless = h.good(H5Pcreate(H5P_FILE_CREATE)), in_memory = h.good(H5Pcreate(H5P_FILE_ACCESS));
  h.good(H5Pset_obj_track_times(timeless, false));
  constexpr std::size_t step = std::size_t{1} << 20U;  // [bytes]
  h.good(H5Pset_fapl_core(in_memory, step, false));
  h.id = h.good(H5Fcreate(h.file.c_str(), H5F_ACC_TRUNC, timeless, in_memory));
  H5Pclose(timeless);
  H5Pclose(in_memory);
  const hid_t root = h.good(H5Gopen2(h.id, "/", H5P_DEFAULT));
  h.say(root, "title", "laser radar cross section of " + scene.target.file.filename().string());
  h.say(root, "program", fmt::format("lrcs {}", version));
  h.say(root, "scene_sha256", scene.digest);
  h.say(root, "target_sha256", loaded.digest);
  if (scene.wavelength > 0.0) h.good(H5LTset_attribute_double(h.id, "/", "wavelength_m", &scene.wavelength, 1));
  H5Gclose(root);
  h.make_facets();
}

SweepHdf5::~SweepHdf5() {
  if (hidden_->facet_sigma >= 0) H5Dclose(hidden_->facet_sigma);
  if (hidden_->seen_fraction >= 0) H5Dclose(hidden_->seen_fraction);
  if (hidden_->id >= 0) H5Fclose(hidden_->id);
}

void SweepHdf5::write_facets(std::size_t row, const CrossSection& section) {
  keep_quiet();
  const auto& rows = hidden_->facet_rows;
  const auto place = static_cast<std::size_t>(std::lower_bound(rows.begin(), rows.end(), row) - rows.begin());
  hidden_->put_row(hidden_->facet_sigma, place, section.facet_sigma);
  hidden_->put_row(hidden_->seen_fraction, place, section.seen_fraction);
}

void SweepHdf5::finish(const std::vector<SweepRow>& rows) {
  Hidden& h = *hidden_;
  h.put_rows(rows);
  for (hid_t* data : {&h.facet_sigma, &h.seen_fraction}) {
    if (*data >= 0) h.good(H5Dclose(*data));
    *data = H5I_INVALID_HID;
  }
  h.good(H5Fflush(h.id, H5F_SCOPE_GLOBAL));
  std::string content(static_cast<std::size_t>(h.good(H5Fget_file_image(h.id, nullptr, 0))), '\0');
  h.good(H5Fget_file_image(h.id, content.data(), content.size()));
  write_whole_file(h.file, content);
}

}  // namespace lrcs
