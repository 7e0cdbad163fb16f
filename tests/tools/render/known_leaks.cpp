// SPDX-License-Identifier: Apache-2.0
// Mesa keeps a few tables for the life of the process; with a leak checker they are not ours to
// free.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so\nleak:libEGL\nleak:_dri.so\nleak:libgallium\nleak:libGLdispatch\n";
}
