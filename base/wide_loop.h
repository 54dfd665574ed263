#pragma once

// Before a function that is one loop over arrays: compiled for several widths of vectors, one of which is chosen when
// the program starts. law: the same bytes from each, for no operation is contracted or reordered.
#define LRCS_WIDE __attribute__((target_clones("default", "avx2", "avx512f")))
