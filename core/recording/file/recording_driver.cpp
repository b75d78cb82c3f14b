#include "core/recording/file/recording_driver.h"

#include <atomic>

namespace fyd::recording {
namespace {

struct DriverInfo {  // HDF5 copies it byte by byte
  const std::shared_ptr<JournaledFile>* file = nullptr;
  bool find_end = false;
};

struct DriverFile {
  H5FD_t common{};  // first: HDF5 knows the rest by its address
  std::shared_ptr<JournaledFile> disk;
  bool find_end = false;
  haddr_t end_of_space = 0;
  std::uint64_t number = 0;
};

DriverFile& own(H5FD_t* file) { return *reinterpret_cast<DriverFile*>(file); }
const DriverFile& own(const H5FD_t* file) { return *reinterpret_cast<const DriverFile*>(file); }

H5FD_t* open(const char*, unsigned, hid_t access, haddr_t) {
  static std::atomic<std::uint64_t> opened{0};
  const auto* info = static_cast<const DriverInfo*>(H5Pget_driver_info(access));
  if (info == nullptr || info->file == nullptr) return nullptr;
  auto file = std::make_unique<DriverFile>();
  file->disk = *info->file;
  file->find_end = info->find_end;
  file->number = ++opened;
  return &file.release()->common;  // HDF5 owns it until `close`
}

herr_t close(H5FD_t* file) {
  const std::unique_ptr<DriverFile> owned(&own(file));
  return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) {
  return own(a).number < own(b).number ? -1 : own(a).number > own(b).number ? 1 : 0;
}

herr_t query(const H5FD_t*, unsigned long* features) {
  *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
              H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_SUPPORTS_SWMR_IO | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t endOfSpace(const H5FD_t* file, H5FD_mem_t) { return own(file).end_of_space; }

herr_t setEndOfSpace(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  DriverFile& f = own(file);
  f.end_of_space = f.find_end ? std::max<haddr_t>(end, f.disk->size()) : end;
  return 0;
}

// HDF5 opens no file that is shorter than it says. Of one that was cut short, what is there shall be read.
haddr_t endOfFile(const H5FD_t* file, H5FD_mem_t) {
  const JournaledFile& disk = *own(file).disk;
  return disk.size() + disk.missingBytes();
}

// A killed recorder may have left its last block unfinished, so a read may reach this far beyond the end of the file.
// Reads further beyond it are errors, and never is more read than the file can hold.
constexpr std::uint64_t kMostBeyondEnd = 1U << 20U;

herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, size_t size, void* out) {
  const JournaledFile& disk = *own(file).disk;
  const auto beyond = [&](std::uint64_t bytes) {
    const std::uint64_t end = bytes + disk.missingBytes() + kMostBeyondEnd;
    return size > bytes + kMostBeyondEnd || at > end || size > end - at;
  };
  if (beyond(disk.size()) && beyond(disk.sizeNow())) return -1;
  return disk.read(at, {static_cast<std::byte*>(out), size}) == 0 ? 0 : -1;
}

herr_t write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, size_t size, const void* bytes) {
  own(file).disk->write(at, {static_cast<const std::byte*>(bytes), size});
  return 0;
}

herr_t truncate(H5FD_t* file, hid_t, hbool_t) {
  own(file).disk->reach(own(file).end_of_space);
  return 0;
}

// HDF5 marks a file as being written, which its other readers look for, only when the driver can lock. The recorder's
// own lock (recording_place.h) marks the process that records; it does not conflict with the locks of HDF5's readers.
herr_t handle(H5FD_t* file, hid_t, void** out) {
  *out = own(file).disk.get();
  return 0;
}

herr_t lock(H5FD_t*, hbool_t) { return 0; }
herr_t unlock(H5FD_t*) { return 0; }

H5FD_class_t makeDriver() {
  H5FD_class_t driver{};
  driver.name = "fyd_journal";
  driver.maxaddr = static_cast<haddr_t>(std::numeric_limits<off_t>::max());
  driver.fc_degree = H5F_CLOSE_STRONG;
  driver.fapl_size = sizeof(DriverInfo);
  driver.open = open;
  driver.close = close;
  driver.cmp = compare;
  driver.query = query;
  driver.get_eoa = endOfSpace;
  driver.set_eoa = setEndOfSpace;
  driver.get_eof = endOfFile;
  driver.get_handle = handle;
  driver.read = read;
  driver.write = write;
  driver.truncate = truncate;
  driver.lock = lock;
  driver.unlock = unlock;
  const H5FD_mem_t map[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(map), std::end(map), std::begin(driver.fl_map));
  return driver;
}

hid_t driverId() {
  static const H5FD_class_t kDriver = makeDriver();
  static const hid_t kId = H5FDregister(&kDriver);
  if (kId < 0) failHard("HDF5 does not take the console's driver");
  return kId;
}

}  // namespace

Handle accessThrough(const std::shared_ptr<JournaledFile>& file, bool find_end) {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
  const DriverInfo info{&file, find_end};
  check(H5Pset_driver(access.id(), driverId(), &info), "access");
  check(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), "access");
  check(H5Pset_fclose_degree(access.id(), H5F_CLOSE_STRONG), "access");
  return access;
}

std::uint64_t diskBytes(hid_t file) {
  const Handle access(H5Fget_access_plist(file), H5Pclose, "access");
  if (H5Pget_driver(access.id()) != driverId()) failHard("not opened through the console's driver");
  void* disk = nullptr;
  check(H5Fget_vfd_handle(file, H5P_DEFAULT, &disk), "the file");
  return static_cast<const JournaledFile*>(disk)->diskBytes();
}

}  // namespace fyd::recording
