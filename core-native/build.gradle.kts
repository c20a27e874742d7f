plugins {
    alias(libs.plugins.android.library)
}

android {
    namespace = "org.echoway.core"
    compileSdk = libs.versions.compileSdk.get().toInt()
    ndkVersion = libs.versions.ndk.get()

    defaultConfig {
        minSdk = libs.versions.minSdk.get().toInt()
        consumerProguardFiles("android/consumer-rules.pro")
        externalNativeBuild {
            cmake {
                // Pages of 16 KiB; contraction off is the core's own compile option.
                arguments += listOf(
                    "-DANDROID_SUPPORT_FLEXIBLE_PAGE_SIZES=ON", "-DECHOWAY_JNI=ON", "-DECHOWAY_HOST=OFF",
                )
                targets += "echoway_jni"
            }
        }
        ndk {
            abiFilters += listOf("arm64-v8a", "armeabi-v7a", "x86_64")
        }
    }

    externalNativeBuild {
        cmake {
            path = file("CMakeLists.txt")
            version = libs.versions.cmake.get()
        }
    }

    sourceSets {
        getByName("main") {
            manifest.srcFile("android/AndroidManifest.xml")
            kotlin.directories += "android/kotlin"
        }
    }

    compileOptions {
        sourceCompatibility = JavaVersion.VERSION_17
        targetCompatibility = JavaVersion.VERSION_17
    }
}
