// The 6x6 solve of align_step.glsl. Reads total[0..20] = lower triangle of H row by row and
// total[21..26] = b; needs kDamping, kMinPivot, kHuge.

int triangle(int row, int column) { return row * (row + 1) / 2 + column; }

// L of D H D + kDamping I with D = diag(H)^-1/2; false when a diagonal entry or a pivot is too small.
bool factorise(out float scale[6], out float L[21]) {
  for (int i = 0; i < 6; ++i) {
    float diagonal = total[triangle(i, i)];
    if (!(diagonal > kMinPivot)) return false;
    scale[i] = inversesqrt(diagonal);
  }
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j <= i; ++j) {
      float sum = scale[i] * scale[j] * total[triangle(i, j)] + (i == j ? kDamping : 0.0);
      for (int k = 0; k < j; ++k) sum -= L[triangle(i, k)] * L[triangle(j, k)];
      if (i == j && !(sum > kMinPivot)) return false;
      L[triangle(i, j)] = i == j ? sqrt(sum) : sum / L[triangle(j, j)];
    }
  }
  return true;
}

bool solveDamped(out float delta[6]) {
  float scale[6];
  float L[21];
  if (!factorise(scale, L)) return false;
  for (int i = 0; i < 6; ++i) {
    float sum = scale[i] * total[21 + i];
    for (int k = 0; k < i; ++k) sum -= L[triangle(i, k)] * delta[k];
    delta[i] = sum / L[triangle(i, i)];
  }
  for (int i = 5; i >= 0; --i) {
    float sum = delta[i];
    for (int k = i + 1; k < 6; ++k) sum -= L[triangle(k, i)] * delta[k];
    delta[i] = sum / L[triangle(i, i)];
  }
  bool finite = true;
  for (int i = 0; i < 6; ++i) {
    delta[i] *= scale[i];
    finite = finite && abs(delta[i]) < kHuge;
  }
  return finite;
}
