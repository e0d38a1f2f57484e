#include "lib/run/command_line/build_id.h"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace shoal {

namespace {

constexpr size_t kNoteAlign = 4;

size_t Aligned(size_t size) { return (size + kNoteAlign - 1) / kNoteAlign * kNoteAlign; }

/// FNV-1a, 64 bits: the ids are hashes already.
void Absorb(const unsigned char* bytes, size_t size, uint64_t* state) {
  constexpr uint64_t kPrime = 1099511628211U;
  for (size_t i = 0; i < size; ++i) *state = (*state ^ bytes[i]) * kPrime;
}

/// Absorbs the build id among the notes that begin at `notes`.
void AbsorbId(const unsigned char* notes, size_t size, uint64_t* state) {
  for (size_t at = 0; at + sizeof(ElfW(Nhdr)) <= size;) {
    ElfW(Nhdr) header;
    std::memcpy(&header, notes + at, sizeof header);
    const size_t name = at + sizeof header;
    const size_t text = name + Aligned(header.n_namesz);
    if (text + header.n_descsz > size) return;
    constexpr char kGnu[] = "GNU";  // With the zero behind it, as in the note.
    if (header.n_type == NT_GNU_BUILD_ID && header.n_namesz == sizeof kGnu &&
        std::memcmp(notes + name, kGnu, sizeof kGnu) == 0) {
      Absorb(notes + text, header.n_descsz, state);
    }
    at = text + Aligned(header.n_descsz);
  }
}

/// Of the program itself, which has no name here, and of shoal's libraries.
bool IsOurs(const dl_phdr_info& object) {
  const std::string_view path(object.dlpi_name);
  return path.empty() || path.find("libshoal") != std::string_view::npos;
}

}  // namespace

std::string BuildId() {
  constexpr uint64_t kStart = 14695981039346656037U;
  uint64_t state = kStart;
  dl_iterate_phdr(
      [](dl_phdr_info* object, size_t, void* into) {
        if (!IsOurs(*object)) return 0;
        for (size_t i = 0; i < object->dlpi_phnum; ++i) {
          const auto& part = object->dlpi_phdr[i];
          if (part.p_type != PT_NOTE) continue;
          // The loader states addresses as numbers.
          const auto* notes =  // NOLINTNEXTLINE(performance-no-int-to-ptr)
              reinterpret_cast<const unsigned char*>(object->dlpi_addr + part.p_vaddr);
          AbsorbId(notes, part.p_memsz, static_cast<uint64_t*>(into));
        }
        return 0;
      },
      &state);
  return state == kStart ? "unknown" : fmt::format("{:016x}", state);
}

}  // namespace shoal
