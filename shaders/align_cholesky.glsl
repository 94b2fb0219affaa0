// The 6x6 solve of align_solve.comp. Reads total[0..20] = lower triangle of H row by row and
// total[21..26] = b; needs kDamping, kMinPivot, kHuge. In blocks of three, without loops and branches: compilers of
// mobile GPUs leave a loop over a triangle as it is, and an array that it indexes ends up in memory.

// L of a symmetric positive A, of which the lower triangle is read; the diagonal is inverted. When a pivot is too
// small, is_positive becomes false.
mat3 factorise(mat3 A, inout bool is_positive) {
  vec3 pivot;
  mat3 L = mat3(0.0);
  pivot.x = A[0][0];
  L[0][0] = inversesqrt(max(pivot.x, kMinPivot));
  L[0][1] = A[0][1] * L[0][0];
  L[0][2] = A[0][2] * L[0][0];
  pivot.y = A[1][1] - L[0][1] * L[0][1];
  L[1][1] = inversesqrt(max(pivot.y, kMinPivot));
  L[1][2] = (A[1][2] - L[0][1] * L[0][2]) * L[1][1];
  pivot.z = A[2][2] - L[0][2] * L[0][2] - L[1][2] * L[1][2];
  L[2][2] = inversesqrt(max(pivot.z, kMinPivot));
  is_positive = is_positive && all(greaterThan(pivot, vec3(kMinPivot)));
  return L;
}

// x of L x = b.
vec3 solveLower(mat3 L, vec3 b) {
  vec3 x;
  x.x = b.x * L[0][0];
  x.y = (b.y - L[0][1] * x.x) * L[1][1];
  x.z = (b.z - L[0][2] * x.x - L[1][2] * x.y) * L[2][2];
  return x;
}

// x of L^T x = b.
vec3 solveUpper(mat3 L, vec3 b) {
  vec3 x;
  x.z = b.z * L[2][2];
  x.y = (b.y - L[1][2] * x.z) * L[1][1];
  x.x = (b.x - L[0][1] * x.y - L[0][2] * x.z) * L[0][0];
  return x;
}

// delta of (D H D + kDamping I) D^-1 delta = D b with D = diag(H)^-1/2; false when a diagonal entry, a pivot or delta
// is out of range.
bool solveDamped(out vec3 delta_v, out vec3 delta_w) {
  vec3 diagonal_v = vec3(total[0], total[2], total[5]);
  vec3 diagonal_w = vec3(total[9], total[14], total[20]);
  bool ok = all(greaterThan(diagonal_v, vec3(kMinPivot))) && all(greaterThan(diagonal_w, vec3(kMinPivot)));
  vec3 scale_v = inversesqrt(max(diagonal_v, kMinPivot));
  vec3 scale_w = inversesqrt(max(diagonal_w, kMinPivot));
  // H = (V K^T; K W); columns of the lower triangles, and the rows of K.
  mat3 V = mat3(1.0 + kDamping, scale_v.x * scale_v.yz * vec2(total[1], total[3]),
                0.0, 1.0 + kDamping, scale_v.y * scale_v.z * total[4],
                0.0, 0.0, 1.0 + kDamping);
  mat3 W = mat3(1.0 + kDamping, scale_w.x * scale_w.yz * vec2(total[13], total[18]),
                0.0, 1.0 + kDamping, scale_w.y * scale_w.z * total[19],
                0.0, 0.0, 1.0 + kDamping);
  mat3 L_v = factorise(V, ok);
  vec3 row0 = solveLower(L_v, scale_w.x * scale_v * vec3(total[6], total[7], total[8]));
  vec3 row1 = solveLower(L_v, scale_w.y * scale_v * vec3(total[10], total[11], total[12]));
  vec3 row2 = solveLower(L_v, scale_w.z * scale_v * vec3(total[15], total[16], total[17]));
  W[0] -= vec3(dot(row0, row0), dot(row1, row0), dot(row2, row0));
  W[1].yz -= vec2(dot(row1, row1), dot(row2, row1));
  W[2].z -= dot(row2, row2);
  mat3 L_w = factorise(W, ok);

  vec3 v = solveLower(L_v, scale_v * vec3(total[21], total[22], total[23]));
  vec3 w = scale_w * vec3(total[24], total[25], total[26]) - vec3(dot(row0, v), dot(row1, v), dot(row2, v));
  w = solveUpper(L_w, solveLower(L_w, w));
  v = solveUpper(L_v, v - row0 * w.x - row1 * w.y - row2 * w.z);
  delta_v = scale_v * v;
  delta_w = scale_w * w;
  return ok && all(lessThan(abs(delta_v), vec3(kHuge))) && all(lessThan(abs(delta_w), vec3(kHuge)));
}
