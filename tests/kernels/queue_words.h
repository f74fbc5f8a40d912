#pragma once
// A queue in the memory of the host: items are filled and read field by field, as on the device.

#include "device/layout.h"
#include "eikonal/portable.h"

#include <cstring>
#include <vector>

namespace eikonal {

class QueueWords {
public:
    /// All words hold `fill`.
    QueueWords(QueueLayout layout, size_t capacity, uint fill = 0)
        : layout_(std::move(layout)), capacity_(capacity), words_(static_cast<size_t>(layout_.words) * capacity, fill) {}

    size_t capacity() const { return capacity_; }
    const QueueLayout& layout() const { return layout_; }
    std::vector<uint>& words() { return words_; }
    const std::vector<uint>& words() const { return words_; }

    /// A field of item i; T is the field's type. A field whose feature is absent reads as zero and is not written.
    template <class T> T get(const char* field, size_t i) const {
        T value{};
        const FieldLayout& f = layout_.field(field);
        uint raw[sizeof(T) / sizeof(uint)] = {};
        for (int w = 0; w < f.words; ++w) raw[w] = word(f.slot + w, i);
        std::memcpy(&value, raw, sizeof value);
        return value;
    }
    template <class T> void set(const char* field, size_t i, T value) {
        const FieldLayout& f = layout_.field(field);
        uint raw[sizeof(T) / sizeof(uint)];
        std::memcpy(raw, &value, sizeof value);
        for (int w = 0; w < f.words; ++w) words_[static_cast<size_t>(f.slot + w) * capacity_ + i] = raw[w];
    }
    uint word(int slot, size_t i) const { return words_[static_cast<size_t>(slot) * capacity_ + i]; }
    void setWord(int slot, size_t i, uint value) { words_[static_cast<size_t>(slot) * capacity_ + i] = value; }

private:
    QueueLayout layout_;
    size_t capacity_;
    std::vector<uint> words_;
};

}  // namespace eikonal
