// Tree reduction over one workgroup: partial[k][i] of all invocations i into partial[k][0], k < TREE_SUMS.
// Fixed order: the same input gives the same bits.
shared float partial[TREE_SUMS][GROUP_SIZE];

void reduceTree() {
  int i = int(gl_LocalInvocationID.x);
  for (int half_size = GROUP_SIZE / 2; half_size > 0; half_size /= 2) {
    memoryBarrierShared();
    barrier();
    if (i < half_size) {
      for (int k = 0; k < TREE_SUMS; ++k) partial[k][i] += partial[k][i + half_size];
    }
  }
}
