//! Vectors of one, four or eight `f64`. The kernels are written once, over the trait [`Lanes`], and compiled for each
//! width.
//!
//! Every operation is a single correctly rounded IEEE operation on every lane, and no two operations are fused, so all
//! instances give the same bits. The instance is chosen at run time ([`LaneWidth::get`]).

#![allow(unsafe_code, reason = "the instructions for vectors exist on some processors only")]

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Sub};

/// `WIDTH` numbers. In the skewed sweep lane `r` belongs to row `r` of a band, one column behind lane `r - 1`.
pub(crate) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    const WIDTH: usize;
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask>;
    /// Proof that this processor has the instructions. A value of this type exists only if it has them. Numbers and
    /// masks can be made only from such a value, so that every operation on them is sound.
    type Simd: Copy + std::fmt::Debug;
    fn splat(simd: Self::Simd, value: f64) -> Self;
    /// Loads the first `WIDTH` numbers of a list that has at least `WIDTH` numbers.
    fn load(simd: Self::Simd, from: &[f64]) -> Self;
    /// The proof from which these numbers were made.
    fn simd(self) -> Self::Simd;
    /// The same number on every lane, as [`splat`](Self::splat).
    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        Self::splat(self.simd(), value)
    }
    fn sqrt(self) -> Self;
    fn less(self, other: Self) -> Self::Mask;
    fn at_most(self, other: Self) -> Self::Mask;
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Returns the mask as bits: lane `r` is bit `r`.
    fn bits(mask: Self::Mask) -> u32;
    fn from_bits(simd: Self::Simd, bits: u32) -> Self::Mask;
    /// Moves every lane up by one; `first` becomes lane 0.
    fn shift_in(self, first: f64) -> Self;
    fn last(self) -> f64;
    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.lanes()[lane]
    }
    /// Returns all lanes. Entries beyond `WIDTH` are zero.
    fn lanes(self) -> [f64; MOST_LANES];
    /// Runs a task with this instance's instructions enabled.
    fn run<T: Task<Self>>(simd: Self::Simd, task: T) -> T::Output;
}

/// Largest [`Lanes::WIDTH`] of all instances.
pub(crate) const MOST_LANES: usize = 8;

/// A piece of work over lanes. `run` must be `#[inline(always)]`, so that it is compiled for the instance's
/// instructions.
pub(crate) trait Task<V: Lanes> {
    type Output;
    fn run(self) -> Self::Output;
}

impl Lanes for f64 {
    const WIDTH: usize = 1;
    type Mask = bool;
    type Simd = ();
    #[inline(always)]
    fn splat((): (), value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn load((): (), from: &[f64]) -> Self {
        from[0]
    }
    #[inline(always)]
    fn simd(self) {}
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> bool {
        self <= other
    }
    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    #[inline(always)]
    fn bits(mask: bool) -> u32 {
        u32::from(mask)
    }
    #[inline(always)]
    fn from_bits((): (), bits: u32) -> bool {
        bits & 1 == 1
    }
    #[inline(always)]
    fn shift_in(self, first: f64) -> Self {
        first
    }
    #[inline(always)]
    fn last(self) -> f64 {
        self
    }
    #[inline(always)]
    fn lanes(self) -> [f64; MOST_LANES] {
        let mut all = [0.0; MOST_LANES];
        all[0] = self;
        all
    }
    #[inline(always)]
    fn run<T: Task<Self>>((): (), task: T) -> T::Output {
        task.run()
    }
}

/// The instance of [`Lanes`] to use, with the proof that this processor has its instructions. It is the widest that the
/// processor has, or a narrower one in tests, which compare all instances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LaneWidth {
    Plain,
    #[cfg(target_arch = "x86_64")]
    Four(Avx2),
    #[cfg(target_arch = "x86_64")]
    Eight(Avx512),
}

impl LaneWidth {
    pub(crate) fn get() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            if let Some(avx512) = Avx512::detect() {
                return Self::Eight(avx512);
            }
            if let Some(avx2) = Avx2::detect() {
                return Self::Four(avx2);
            }
        }
        Self::Plain
    }

    /// All instances that this processor can run, the narrowest first.
    #[cfg(test)]
    pub(crate) fn all() -> Vec<Self> {
        #[allow(unused_mut, reason = "other processors have the plain one only")]
        let mut all = vec![Self::Plain];
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(Avx2::detect().map(Self::Four));
            all.extend(Avx512::detect().map(Self::Eight));
        }
        all
    }
}

/// Evaluates `$body`, in which the type `$lanes` is the instance that `$widest` names and `$simd` is its proof.
macro_rules! with_lanes {
    ($widest:expr, $lanes:ident, $simd:ident => $body:expr) => {
        match $widest {
            $crate::graph::lanes::LaneWidth::Plain => {
                type $lanes = f64;
                let $simd = ();
                $body
            }
            #[cfg(target_arch = "x86_64")]
            $crate::graph::lanes::LaneWidth::Four($simd) => {
                type $lanes = $crate::graph::lanes::Four;
                $body
            }
            #[cfg(target_arch = "x86_64")]
            $crate::graph::lanes::LaneWidth::Eight($simd) => {
                type $lanes = $crate::graph::lanes::Eight;
                $body
            }
        }
    };
}
pub(crate) use with_lanes;

#[cfg(target_arch = "x86_64")]
pub(crate) use wide::{Avx2, Avx512, Eight, Four};

#[cfg(target_arch = "x86_64")]
mod wide {
    use super::{Lanes, MOST_LANES, Task};
    use std::arch::x86_64::*;
    use std::ops::{Add, BitAnd, BitOr, Div, Mul, Sub};

    /// Proof that this processor has AVX2.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub(crate) struct Avx2(());

    impl Avx2 {
        pub(crate) fn detect() -> Option<Self> {
            std::arch::is_x86_feature_detected!("avx2").then_some(Self(()))
        }
    }

    /// Proof that this processor has AVX-512 F, DQ and VL.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub(crate) struct Avx512(());

    impl Avx512 {
        pub(crate) fn detect() -> Option<Self> {
            let all = std::arch::is_x86_feature_detected!("avx512f")
                && std::arch::is_x86_feature_detected!("avx512dq")
                && std::arch::is_x86_feature_detected!("avx512vl");
            all.then_some(Self(()))
        }
    }

    /// Four numbers in one AVX2 register. Its field is private to this module, and every function here that makes one
    /// takes an [`Avx2`] or another `Four`: where a value exists, the processor has the instructions. Every `unsafe`
    /// call of an intrinsic below is therefore sound.
    #[derive(Clone, Copy)]
    pub(crate) struct Four(__m256d);
    /// A mask that is made of [`Four`]s or with an [`Avx2`] only.
    #[derive(Clone, Copy)]
    pub(crate) struct FourMask(__m256d);

    /// Eight numbers in one AVX-512 register. An [`Avx512`] is its proof, as [`Avx2`] is that of [`Four`].
    #[derive(Clone, Copy)]
    pub(crate) struct Eight(__m512d);
    /// A mask that is made of [`Eight`]s or with an [`Avx512`] only.
    #[derive(Clone, Copy)]
    pub(crate) struct EightMask(__mmask8);

    macro_rules! operator {
        ($trait:ident, $method:ident, $type:ident, $intrinsic:ident) => {
            impl $trait for $type {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    // SAFETY: a value of this type exists only on processors with its instructions.
                    Self(unsafe { $intrinsic(self.0, other.0) })
                }
            }
        };
    }
    operator!(Add, add, Four, _mm256_add_pd);
    operator!(Sub, sub, Four, _mm256_sub_pd);
    operator!(Mul, mul, Four, _mm256_mul_pd);
    operator!(Div, div, Four, _mm256_div_pd);
    operator!(BitAnd, bitand, FourMask, _mm256_and_pd);
    operator!(BitOr, bitor, FourMask, _mm256_or_pd);
    operator!(Add, add, Eight, _mm512_add_pd);
    operator!(Sub, sub, Eight, _mm512_sub_pd);
    operator!(Mul, mul, Eight, _mm512_mul_pd);
    operator!(Div, div, Eight, _mm512_div_pd);

    impl BitAnd for EightMask {
        type Output = Self;
        #[inline(always)]
        fn bitand(self, other: Self) -> Self {
            Self(self.0 & other.0)
        }
    }
    impl BitOr for EightMask {
        type Output = Self;
        #[inline(always)]
        fn bitor(self, other: Self) -> Self {
            Self(self.0 | other.0)
        }
    }

    impl Lanes for Four {
        const WIDTH: usize = 4;
        type Mask = FourMask;
        type Simd = Avx2;
        #[inline(always)]
        fn splat(Avx2(()): Avx2, value: f64) -> Self {
            // SAFETY: an `Avx2` exists only on processors with AVX2.
            Self(unsafe { _mm256_set1_pd(value) })
        }
        #[inline(always)]
        fn load(Avx2(()): Avx2, from: &[f64]) -> Self {
            let from: &[f64; 4] = from.first_chunk().expect("a full load");
            // SAFETY: an `Avx2` exists only on processors with AVX2; there are four numbers; no alignment needed.
            Self(unsafe { _mm256_loadu_pd(from.as_ptr()) })
        }
        #[inline(always)]
        fn simd(self) -> Avx2 {
            Avx2(())
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            // SAFETY: a `Four` exists only on processors with AVX2.
            Self(unsafe { _mm256_sqrt_pd(self.0) })
        }
        #[inline(always)]
        fn less(self, other: Self) -> FourMask {
            // SAFETY: a `Four` exists only on processors with AVX2.
            FourMask(unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0) })
        }
        #[inline(always)]
        fn at_most(self, other: Self) -> FourMask {
            // SAFETY: a `Four` exists only on processors with AVX2.
            FourMask(unsafe { _mm256_cmp_pd::<_CMP_LE_OQ>(self.0, other.0) })
        }
        #[inline(always)]
        fn select(mask: FourMask, yes: Self, no: Self) -> Self {
            // SAFETY: a `Four` exists only on processors with AVX2.
            Self(unsafe { _mm256_blendv_pd(no.0, yes.0, mask.0) })
        }
        #[inline(always)]
        fn bits(mask: FourMask) -> u32 {
            // SAFETY: a `FourMask` exists only on processors with AVX2.
            unsafe { _mm256_movemask_pd(mask.0) as u32 }
        }
        #[inline(always)]
        fn from_bits(Avx2(()): Avx2, bits: u32) -> FourMask {
            // SAFETY: an `Avx2` exists only on processors with AVX2.
            unsafe {
                let lanes = _mm256_set_epi64x(8, 4, 2, 1);
                let set = _mm256_and_si256(_mm256_set1_epi64x(i64::from(bits)), lanes);
                FourMask(_mm256_castsi256_pd(_mm256_cmpeq_epi64(set, lanes)))
            }
        }
        #[inline(always)]
        fn shift_in(self, first: f64) -> Self {
            // SAFETY: a `Four` exists only on processors with AVX2.
            unsafe {
                let moved = _mm256_permute4x64_pd::<0b10_01_00_00>(self.0);
                Self(_mm256_blend_pd::<1>(moved, _mm256_set1_pd(first)))
            }
        }
        #[inline(always)]
        fn last(self) -> f64 {
            // SAFETY: a `Four` exists only on processors with AVX2.
            unsafe {
                let high = _mm256_extractf128_pd::<1>(self.0);
                _mm_cvtsd_f64(_mm_unpackhi_pd(high, high))
            }
        }
        #[inline(always)]
        fn lanes(self) -> [f64; MOST_LANES] {
            let mut all = [0.0; MOST_LANES];
            // SAFETY: a `Four` exists only on processors with AVX2; there is room for four.
            unsafe { _mm256_storeu_pd(all.as_mut_ptr(), self.0) };
            all
        }
        #[inline(always)]
        fn run<T: Task<Self>>(Avx2(()): Avx2, task: T) -> T::Output {
            #[target_feature(enable = "avx2")]
            fn enabled<T: Task<Four>>(task: T) -> T::Output {
                task.run()
            }
            // SAFETY: an `Avx2` exists only on processors with AVX2.
            unsafe { enabled(task) }
        }
    }

    impl Lanes for Eight {
        const WIDTH: usize = 8;
        type Mask = EightMask;
        type Simd = Avx512;
        #[inline(always)]
        fn splat(Avx512(()): Avx512, value: f64) -> Self {
            // SAFETY: an `Avx512` exists only on processors with AVX-512.
            Self(unsafe { _mm512_set1_pd(value) })
        }
        #[inline(always)]
        fn load(Avx512(()): Avx512, from: &[f64]) -> Self {
            let from: &[f64; 8] = from.first_chunk().expect("a full load");
            // SAFETY: an `Avx512` exists only on processors with AVX-512; there are eight numbers; no alignment needed.
            Self(unsafe { _mm512_loadu_pd(from.as_ptr()) })
        }
        #[inline(always)]
        fn simd(self) -> Avx512 {
            Avx512(())
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            // SAFETY: an `Eight` exists only on processors with AVX-512.
            Self(unsafe { _mm512_sqrt_pd(self.0) })
        }
        #[inline(always)]
        fn less(self, other: Self) -> EightMask {
            // SAFETY: an `Eight` exists only on processors with AVX-512.
            EightMask(unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0) })
        }
        #[inline(always)]
        fn at_most(self, other: Self) -> EightMask {
            // SAFETY: an `Eight` exists only on processors with AVX-512.
            EightMask(unsafe { _mm512_cmp_pd_mask::<_CMP_LE_OQ>(self.0, other.0) })
        }
        #[inline(always)]
        fn select(mask: EightMask, yes: Self, no: Self) -> Self {
            // SAFETY: an `Eight` exists only on processors with AVX-512.
            Self(unsafe { _mm512_mask_blend_pd(mask.0, no.0, yes.0) })
        }
        #[inline(always)]
        fn bits(mask: EightMask) -> u32 {
            u32::from(mask.0)
        }
        #[inline(always)]
        fn from_bits(Avx512(()): Avx512, bits: u32) -> EightMask {
            EightMask(bits as u8)
        }
        #[inline(always)]
        fn shift_in(self, first: f64) -> Self {
            // SAFETY: an `Eight` exists only on processors with AVX-512.
            unsafe {
                let (all, first) = (_mm512_castpd_si512(self.0), _mm512_castpd_si512(_mm512_set1_pd(first)));
                Self(_mm512_castsi512_pd(_mm512_alignr_epi64::<7>(all, first)))
            }
        }
        #[inline(always)]
        fn last(self) -> f64 {
            // SAFETY: an `Eight` exists only on processors with AVX-512.
            unsafe {
                let high = _mm512_extractf64x2_pd::<3>(self.0);
                _mm_cvtsd_f64(_mm_unpackhi_pd(high, high))
            }
        }
        #[inline(always)]
        fn lanes(self) -> [f64; MOST_LANES] {
            let mut all = [0.0; MOST_LANES];
            // SAFETY: an `Eight` exists only on processors with AVX-512; there is room for eight.
            unsafe { _mm512_storeu_pd(all.as_mut_ptr(), self.0) };
            all
        }
        #[inline(always)]
        fn run<T: Task<Self>>(Avx512(()): Avx512, task: T) -> T::Output {
            #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
            fn enabled<T: Task<Eight>>(task: T) -> T::Output {
                task.run()
            }
            // SAFETY: an `Avx512` exists only on processors with AVX-512.
            unsafe { enabled(task) }
        }
    }
}

/// A vector on every lane.
#[derive(Clone, Copy)]
pub(crate) struct Vector<V> {
    pub(crate) x: V,
    pub(crate) y: V,
    pub(crate) z: V,
}

impl<V: Lanes> Vector<V> {
    #[inline(always)]
    pub(crate) fn new(x: V, y: V, z: V) -> Self {
        Self { x, y, z }
    }
    #[inline(always)]
    pub(crate) fn zero(simd: V::Simd) -> Self {
        Self::new(V::splat(simd, 0.0), V::splat(simd, 0.0), V::splat(simd, 0.0))
    }
    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> V {
        self.x * other.x + self.y * other.y + self.z * other.z
    }
    #[inline(always)]
    pub(crate) fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }
    #[inline(always)]
    pub(crate) fn minus(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
    #[inline(always)]
    pub(crate) fn times(self, factor: V) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
    /// [`Lanes::shift_in`] on the three components.
    #[inline(always)]
    pub(crate) fn shift_in(self, first: &[f64]) -> Self {
        Self { x: self.x.shift_in(first[0]), y: self.y.shift_in(first[1]), z: self.z.shift_in(first[2]) }
    }
    #[inline(always)]
    pub(crate) fn select(mask: V::Mask, yes: Self, no: Self) -> Self {
        Self { x: V::select(mask, yes.x, no.x), y: V::select(mask, yes.y, no.y), z: V::select(mask, yes.z, no.z) }
    }
}

impl From<plateau_mesh::DVec3> for Vector<f64> {
    fn from(v: plateau_mesh::DVec3) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}
