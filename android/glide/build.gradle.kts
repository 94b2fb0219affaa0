plugins {
    id("com.android.library")
    `maven-publish`
}

group = "io.github.glideslam"
version = "0.1.0"

android {
    namespace = "io.github.glideslam"
    compileSdk = 36
    ndkVersion = "28.2.13676358"

    defaultConfig {
        minSdk = 26
        consumerProguardFiles("consumer-rules.pro")
        ndk {
            abiFilters += listOf("arm64-v8a", "x86_64")
        }
        externalNativeBuild {
            cmake {
                // The C ABI is in it, too. What it links lies where scripts/android_deps.sh puts it: dependencies.cmake.
                targets("glide")
                arguments(
                    "-DANDROID_STL=c++_static",
                    "-DGLIDE_DESKTOP=OFF",
                    "-DCMAKE_PROJECT_INCLUDE=${projectDir}/dependencies.cmake",
                )
            }
        }
    }

    externalNativeBuild {
        cmake {
            path = file("../../CMakeLists.txt")
            version = "3.22.1"
        }
    }

    compileOptions {
        sourceCompatibility = JavaVersion.VERSION_1_8
        targetCompatibility = JavaVersion.VERSION_1_8
    }

    buildFeatures {
        prefabPublishing = true
    }

    prefab {
        // The name of the CMake target, and of the module in the archive of ./glide aar.
        create("glide") {
            headers = "../../core/include"
            libraryName = "libglide_jni"
        }
    }

    publishing {
        singleVariant("release") {
            withSourcesJar()
        }
    }
}

publishing {
    publications {
        register<MavenPublication>("release") {
            artifactId = "glide-slam"
            afterEvaluate {
                from(components["release"])
            }
        }
    }
}
